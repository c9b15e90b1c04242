<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Docks</name>
    <message>
        <source>Probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lobe error</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ExportFormat</name>
    <message>
        <source>%1, 16-bit half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, 32-bit float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, 8 bit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, tone-mapped 8 bit</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fields</name>
    <message>
        <source>0: straight bars; 1: bent as in a mirror ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: straight; 1: lines follow the ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: the bars are gaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: what lies below shows through</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>16-bit floats where the format has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A perfect mirror: shows the environment as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Black rubber: almost no highlight but at grazing angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brushed aluminium: a broad Phong highlight with exponent 60.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cold and warm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colorgram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark glass: clear in front, mirroring towards the edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deep red lacquer under a clear, mirroring coat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fired clay: matt and warm.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glazed white porcelain: bright and matt below, mirroring above.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hatching</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue, saturation, value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Matt white: nothing but diffuse light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenColorIO configuration: a .ocio file, or env for the one that $OCIO names; empty: tone curve and sRGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pearl: a soft sheen over cream.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phong lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Piano lacquer: black, and a sharp reflection on top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polished chromium: a mirror with the cool tint of the metal.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polished gold with a faint bloom.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Polished silver: the brightest of the metals.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Posterize</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red plastic with a soft highlight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Satin copper: a soft, reddish reflection.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Satin-finished light metal: a ggx lobe of roughness 0.4 that mirrors alike at every angle.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouette ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toon bands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a Gaussian blur on the sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a generator: fill, gradient, image, paint, ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a line along the outline of the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a material under a light probe: lobe and Fresnel term baked in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a painted sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a picture of a ball from a file, such as a matcap</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a second set of lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a sphere map that is part of the scene, in place of the source; null: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a tone curve for all channels or one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a whirl around the center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>about the view axis, counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>across-seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>add: F times specular plus diffuse; coat: the diffuse part lies under the reflecting layer, times 1 - F</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>all, or one of the two passes of Blender&apos;s matcaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>aluminium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ambient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle of view from bottom to top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anisotropy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another number, another arrangement</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>arcs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>at the center, counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>authored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>authored: coarser levels as the document makes them; plain: averages, as hardware makes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>away from the eye; 0 is the miner&apos;s hat, a light at the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>azimuth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>balance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>between the two sets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>black-lacquer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blend</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blended</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blue in the shade, yellow in the light, and a white highlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bounds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blurred</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blurred: ggx roughness of the blur</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brightness of the display picture: times 2^exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brightness of the light: radiance times 2^exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brightness: times 2^exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brushed-metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>car-paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cells of the surface that look the map up elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>center-softness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>center-x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>center-y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chain: how many levels; 0: down to one texel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chrome</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chromium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coarser levels, read where a reflection shrinks: no shimmer on strongly curved parts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cold-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color: linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color of the diffuse part, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color of the diffuse pass, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color of the reflection, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colors and where they stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colors between stops, around a center, across, around, or from shade to light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>columns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>combine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>compute probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conductor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conductor: name of a metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>conductor: name of a metal, or custom for n and k below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>config</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>content</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>copper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cross</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cross-angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cross-from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cube with coarser levels: filtered across the seams of the faces, or each face by itself as the hardware of 2002 did, which shows the seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curvature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>curve that brings radiance to the display; auto: a sphere map that replaces the material is shown as it was painted, all else through filmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>custom conductor: extinction for red, green, blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>custom conductor: index of refraction for red, green, blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dark becomes light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>darken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>density</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>description</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dielectric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dielectric: index of refraction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diffuse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direct</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disc radii</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disc radii or pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disc: tips are part of the picture; pixels: as many pixels wide on every level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>disc: wider on flat parts; pixels: the same width everywhere, through levels made for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>display through OpenColorIO</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>document</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>draw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>edge of a face, disc or octahedron, or height of a latlong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exchanges left and right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exponent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>eye: the map turns with the camera; world: it stands still, looked up by world directions</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>factor of the brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>factor; 0: gray; at most as much as a color can hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>far</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>far_depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>few tones instead of many</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filmic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filter specular map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>first-level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flat tones from shade to light, a hard highlight, a rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flecks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>flip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fov</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>frame-opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fresnel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fresnel term</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from black to white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the bottom to the top</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the rim inwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>from the target; the object&apos;s radius is 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ggx</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ggx: 0 is a mirror, 1 fully rough; alpha is its square</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient: colors of one ring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient: drawn at will; grating: diffracted light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient: from the center to the rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient: height of the waves, in rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient: how often the colors run once around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gradient: waves around the rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: extent of the light, which washes the colors out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: from groove to groove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: how they run</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: of straight grooves, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: of the light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: rainbows on each side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: the light, away from the eye; 0: at the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grating: the light, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>groove-angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>grooves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hierarchical</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highlight-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highlight-distance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>highlights of lights, to be added to a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far a fleck&apos;s lookup may lie from the surface&apos;s own, in radii of the disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far lines wander, end early and vary in width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far the colors differ from white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far the panes fade out towards the bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how it meets what lies below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how much is mirrored at which angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how much of it shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how much of the picture&apos;s rim is cut away, where it is cut out badly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the file shows the sphere; auto: found out from the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the picture is taken</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the specular map is filtered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the specular map is filtered; auto: the cheapest method that meets the tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how the surface spreads what it mirrors; diffuse: the matt part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>image file; the disc is inscribed in it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>importance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>importance: samples of the lobe a texel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in the order in which they were drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>inset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>invert</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>iron</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>irradiance map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its kind and the kind&apos;s parameters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>k</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind of the map that the picture reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lambda</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lambda by angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lambda_grazing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest error of the map, rel_rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>largest level of a hand-made mip chain that it takes part in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>last-level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>latitude of the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>latlong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>least mip level of the reflection: blurs it without filtering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>letters, digits, - and _; names the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light at which the band begins: 0 faces away from the light, 1 faces it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light at which the darkest tone ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light everywhere, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light probe: image file, or builtin:NAME</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>light-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lighten</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear, angular: direction, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lines across the disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lobe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lod_bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>longitude of the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lookup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luminance: where the mask is bright; opacity: where it is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>makes the line thicker on one side and thinner on the other, as a pen does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>maps to write</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>match</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>matched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>matte</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle_depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mip levels of specular map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mip: cube faces filtered across their seams, or each by itself as the hardware of 2002 did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mip_filtering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mips</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror, or how a glossy surface spreads the reflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirrored: F; transmitted: 1 - F, for what lies under a coat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves the dividing line: above 0 there is more warmth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>moves the mip level of the reflection by this much; lambda then holds it from below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>multiply</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n.h</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>n.h: the exponent as typed, or the one that looks like r.v with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: alike at every angle; dielectric: glass, lacquer; conductor: metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: mirrors alike at every angle; dielectric: glass, lacquer, water; conductor: metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal-lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>octahedral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a cell; the object&apos;s radius is 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of a full line, as a part of the way to the next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of its edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the bars&apos; width; pixels: the same on every level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the brightest tone, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the configuration; empty: its default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the curve, from dark to bright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the darkest tone, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the display; empty: its default</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the edges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the edges between tones, as light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the highlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the ink, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the inner edge, as a part of the width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the light, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the line, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the lines, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the material&apos;s sphere map behind the pane; the pane is 1.2 wide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the matt part, max(n.l, 0)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the shade, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the white disc from the center, on the warm side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the white disc, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>oklab</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>oklab: steps look even; linear: as light mixes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one color everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one sentence</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>other maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>painted sphere map: a .spheremap file, a picture of one, or a preset; empty: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pane-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>panes and bars, as if a window were mirrored</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>panes one above the other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>panes side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid blended: least border around each half; 0: as far as the kernel reaches</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid blended: size of a half before it shrinks; 0: the probe&apos;s height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid: largest kernel; the map shrinks until it fits; 0: 7 blended, 17 exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid: texels kept free outside each disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid: the kernel ends where the lobe has fallen to this share of its peak; 0: 0.1 blended, 0.001 exact</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid: two kernels blended by the distance from the middle, as published, or exact at every place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid_border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid_clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid_half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid_kernel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>parameterization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part of a step that is a slope</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pearl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pen lines towards the outline or in the shade, and across each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>per-face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>perspective, or orthographic at the size the object has in perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>phong: the larger, the sharper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pitch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixel: exact; vertex: coordinates interpolated between vertices, as hardware of 1999 did</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels: edge of the level on which the tips are as wide as they were drawn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>plastic-red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>point that the eye looks at and orbits; the object&apos;s center is 0, 0, 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>points</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>polar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>porcelain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>quads along a quarter of a circumference; 0: as fine as the picture needs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>r.v</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>r.v: by the mirror direction; n.h: by the half vector</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radial</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radial, linear, angular: center, to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radial, linear, angular: center, up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radial, linear: from the center to the last stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radial: around the center; linear: across; angular: once around; shaded: by the angle to a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius of the highlight; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius of the white center</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius of the white disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>read mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reinhard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>repeat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replace</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replace, multiply: of the surface, linear RGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>replace: shown alone, over the color below; multiply: times that color; over: over the reflecting material; tint: times the reflecting material; add: its light added to the reflecting material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resample background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>resample specular map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rim</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rim-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rim-turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rings</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ripple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>roughness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rubber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>satin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>saturation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>scattered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sh9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shade-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shade-end</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shade: the light, away from the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shade: the light, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shaded</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shaded: the light, away from the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shaded: the light, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the cells that are flecks; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>shows the layer where the mask does not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sigma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>silhouette: lines grow towards the outline; shade: away from a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>silver</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>smallest level that it takes part in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>soft-light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>softness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spectral</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spectrum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>specular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere map behind both; empty: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere map behind that one, seen where it is transparent; empty: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere_map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square root of the channel after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>square root of the channel before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>standard deviation on the sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>straight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strength</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strength of the diffuse part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strength of the reflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>strokes of a brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sweep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>swell-angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>takes part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>target</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>teapot, torus, sphere, box, window, or a mesh file (.obj .ply .stl .off .gltf .glb .fbx .dae .3ds)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tessellation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>texcoords</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>texels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>texels along the edge of the map that the picture reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the center moves to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the center moves up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the environment, the environment blurred, one color, or none (transparent)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the larger, the sharper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the light, away from the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the light, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the map that the picture reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the material, or what it is computed from: triangles, normals as colors or as lines, texture coordinates, seams or levels of the map, the bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the matt part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the mirrored part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window of the geometry of that name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>title</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tone at which lines begin: 0 is the center or full light, 1 the outline or full shade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tone at which the second set begins</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tone at which they are at their widest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tones</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tones of one&apos;s own instead of count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tones, where there are no bands of one&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>transmitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turn of the hue: 120 makes red green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turned counterclockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns hues, strengthens or weakens colors and brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns the camera about its view, counterclockwise seen from behind it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns the environment about +Y, counterclockwise seen from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns the probe about +Y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns the whole ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns what lies outside further: the rings differ left and right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>twist</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>typed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>visible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>warm-color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>weight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what a list shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what happens past the ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what looks it up: the surface&apos;s normal, or the direction that the surface mirrors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what stands behind the object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the artist calls it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what the object is made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where it ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where it is thickest, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where it shows; null: everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where on the gradient; two stops at one place make a hard edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the eye is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the light comes from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the rim is widest, from the light on: 180 is opposite</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where the warm side lies, counterclockwise from the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>where they are and how bright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which of them it changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the bars</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>width of the bright rim; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wireframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with coarser levels: lookups along the longer side of a pixel&apos;s footprint, sharper at grazing angles</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with lambda: sharper where the surface is seen at a grazing angle; 1 as rough surfaces do, more exaggerates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>world</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>world: the environment stands still; eye: the map turns with the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yaw</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>then tips it about +X: what is above moves towards the eye</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A banknote&apos;s engraving: fine lines that swell with the shade.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A black and white sketch of a window, whose bars show the shape.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cream pearl with a faint rose and green lustre.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A glowing outline that fades to nothing in the middle, for adding over anything.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A morning sky, the farthest layer outside a window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Airbrushed chrome: a blue sky, a hard horizon, a desert floor.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anime skin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue hills, a middle layer outside a window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue ice: clear and dark inside, white at the edges, with a frosted light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue velvet, dark in front and bright towards the edges.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blueprint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brushed steel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candy red under a clear coat that mirrors a studio.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Car paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chrome horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cold moonlight in four tones with a magenta rim.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compact disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cyan and magenta tubes on black lacquer.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark mercury with ribbons of light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Deep red sealing wax, soft inside and wet on top.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffraction foil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engraving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glazed white porcelain by a tall studio window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gooch&apos;s cold-warm shading: blue shade, yellow light, a white highlight.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grass, shrubs and trees, the nearest layer outside a window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hills</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holographic gift foil: true diffraction colors over silver.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holographic ribbon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ink outlines on white paper, of the same width whatever the curvature.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Key, fill and rim light, as a portrait photographer sets them.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Liquid metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meadow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Miner&apos;s hat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Neon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Obsidian</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Oil slick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One Phong highlight of a light at the eye over dark plastic.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pearl</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pen lines that gather and cross towards the outline.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pencil</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Petrol colors that swim on black water.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Porcelain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red wax</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ribbons of diffracted color that wind around the ball.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Satin gold in a photographic studio: a real probe under a metal&apos;s Fresnel term.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silhouette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sky</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Soft graphite on toothy paper, shaded by hand.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Studio clay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The spokes of color of a pressed disc under two lamps.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three flat tones of a comic, a hard highlight and an ink line.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Three lights</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toon hero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Toon night</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Translucent green stone that glows where light comes through.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turned steel: bow ties of light around the axis of the lathe.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two soft-edged skin tones with a rosy border between light and shade.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Velvet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Volcanic glass: black, with the studio mirrored by its Fresnel term alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm sculptor&apos;s clay under a soft key light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White lines on blueprint paper.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White, with pastel rainbow arcs towards the edges, to multiply over any surface.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window sketch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X-ray</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rainbow rings and arcs, drawn or diffracted, to be multiplied over a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coarser levels: halved, or as the painted map makes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file name, whose extension is the format; empty: NAME.exr; %s in a cube&apos;s makes six files, %d one file a level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind of the map; painted: always a sphere map&apos;s disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>painted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>source: the environment; specular: filtered with the material&apos;s lobe; diffuse: irradiance over pi; chain: ggx levels of roughness 0 to 1; painted: the sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenEXR: display is the picture, black where the file holds no data; data is only what it holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a picture of one that is not square: stretched, padded, or cropped about its middle; none: refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a picture that is not square: stretched, padded, or cropped about its middle; none: refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a picture whose shape is not its map&apos;s: stretched, padded with black to its angles of view, or cropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beyond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>black</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>color_space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>crop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cube faces in the order in which the file has them, px nx py ny pz nz, each with :90, :180 or :270 where it lies turned; empty: as the arrangement has them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>data</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>horizontal_angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>image file, six or two with a %s, or builtin:NAME</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of the file&apos;s colors: linear, srgb, gamma1.8, gamma2.2, display-p3, adobe-rgb, acescg, ..., or a space of the OpenColorIO configuration that $OCIO names; empty: as the file says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>outside the angles of view: black, or mirrored from the other side, as for a fisheye hemisphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>paraboloid: texels kept free outside each disc; cube: texels of its neighbors around each face; painted: texels between the disc and the picture&apos;s edge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>part</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rotate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stretch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>that the picture spans; 0: found from the shape</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the axis whose sign the file has the other way round</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns the probe about Y, X and Z, Z first: levels a horizon</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>vertical_angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which layer&apos;s channels are the colors; empty: chosen, default: those without a name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>which picture of a file that holds several: its number, from 0, or its name; empty: the one with the colors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cast aluminium: rough, with the tail of ggx.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark green satin lacquer: a dull layer over paint, mirroring at grazing angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sand-blasted copper: Beckmann&apos;s facets, which shift the color at grazing angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Satin gold: a wide lobe that stretches and brightens towards grazing angles.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a lobe that knows the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>blasted-copper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>brdf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cast-aluminium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ggx:roughness=0.5,metal=gold, another model, or a measured file (.binary .brdf .csv .txt), in place of the specular lobe and the Fresnel term; empty: those</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lookups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>satin-gold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>satin-lacquer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>filament</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitted: how many into a ggx chain stand for the lobe at each angle of view; 0: the split sum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fitted: lookups that are fitted to the lobe; split-sum, three, filament: what those show, to compare; exact: the integral over the probe, the truth for all of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>split-sum</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>three</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pattern</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture by the mesh&apos;s texture coordinates, times the color; it repeats beyond 0 to 1; empty: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture by the mesh&apos;s texture coordinates: where it is white, flecks are as dense as said above, where it is black there are none; empty: as dense everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Candy paint: a glossy, colored metal under a clear, mirroring coat.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a clear layer over all of it, with a lobe of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>candy-paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clear_coat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>index of refraction of the layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mirror, or how a glossy layer spreads the reflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>share of the surface that has it; 0: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>8-bit pictures are rounded by a fine pattern of half a step, so that dark gradients show no bands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coat: what it reflects does not get below it; add: its light comes on top, a lobe more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dither</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>how far normals tilt, times the map&apos;s own; 0: not at all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal map of tangent space by the mesh&apos;s texture coordinates, +Y up as in OpenGL; empty: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normal_map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>normals of a finer surface than the mesh</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileDialogs</name>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FileKind</name>
    <message>
        <source>scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scenes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Meshes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light probes and pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenColorIO configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenColorIO configurations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything that can be opened (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ImagePatterns</name>
    <message>
        <source>Images (%1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MousePresets</name>
    <message>
        <source>Left orbits, middle pans</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alt and left orbit, middle pan, right zoom (Maya, Substance)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle orbits, with Shift pans, with Ctrl zooms (Blender)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ProbeGuesses</name>
    <message>
        <source>mirror ball</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>UseFile</name>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change display</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>main</name>
    <message>
        <source>Author materials with environment maps: the desktop tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to open: a scene, a light probe or another picture, a folder of them, a mesh, a sphere map, a material.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::BrushPage</name>
    <message>
        <source>Symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Right drag changes radius and hardness, [ and ] step the radius, Alt picks a color on the disc.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stabilizer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Steadies the hand: the brush follows the pointer on a string of this length; 0 is off</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ColorButton</name>
    <message>
        <source>Copy %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as linear numbers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ColorPicker</name>
    <message>
        <source>Eyedropper</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the next click&apos;s color from anywhere on the screen; Escape ends it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue around, saturation from the middle to the rim; arrow keys turn and move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hex</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red, green and blue as the screen shows them, #rrggbb</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a swatch to choose its color here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Around the wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saturation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From gray to a pure color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From black to the brightest that a screen shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops above what a screen shows: a highlight or a lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kelvin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The color of a glowing body of this temperature</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>K</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts this color among those that are kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recent color %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kept color %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ColorScaleBar</name>
    <message>
        <source>Signed difference in luminance: blue is darker, orange brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminance, on a logarithmic scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid angle of a texel over the mean one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anisotropy: the longer axis of a texel&apos;s circle of directions over the shorter</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::CommandPalette</name>
    <message>
        <source>Command palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type a command, or the name of a control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters of it, in their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or click runs the command, or goes to the control</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ComparisonLabels</name>
    <message>
        <source>A: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>B: now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>4 |A − B|, A: %1, B: now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ContentForm</name>
    <message>
        <source>Widths in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a picture of a ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::CurveEditor</name>
    <message>
        <source>Before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen point across: square root of the light that comes in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>After</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen point upwards: square root of the light that goes out; above 1 it is brighter than white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the straight line, which changes nothing</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::CurvePlot</name>
    <message>
        <source>Tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;p&gt;Across: what the layer gets; up: what it makes of it. Both are square roots of linear light, about as the eye sees it: 0 is black, 1 is white. Brighter light keeps its ratios.&lt;/p&gt;&lt;p&gt;Click for a new point, drag to move it, pull it away or press Delete to remove it; double-click a point to put it back on the diagonal. Arrow keys move it, with Shift finer; Ctrl and arrows go from point to point.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::DiscHandles</name>
    <message>
        <source>%1 %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a light, or double-click to add one; to paint, choose a paint layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a handle to change the layer; to paint, choose a paint layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move a handle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::DoctorDialog</name>
    <message>
        <source>What is this map? - %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The light probe that the map was filtered from: with it the doctor measures orientation and errors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not known</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the scene&apos;s probe, %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the doctor says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map is, and what is wrong with it; the command &quot;doctor&quot; says the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map is examined…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Made from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the words</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map was made from</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::Document</name>
    <message>
        <source>Untitled</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::DropTarget</name>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::EditActions</name>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the chosen layer while the sphere map has the keys, else the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste layers, a picture or files: what a drop at the place of the keys would do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the chosen layer of the sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was pasted: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture cannot be kept: its folder cannot be written; save the scene in another one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::EngineCard</name>
    <message>
        <source>environment, latlong</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>environment, cube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>specular levels, cube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diffuse light, cube</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>specular levels and diffuse light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>specular levels and diffuse light, atlas</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>diffuse light, nine coefficients</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>what loads or describes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not proven: written from its sources, it cannot run in the tests</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>proven in %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Proof</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the engine does with the files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warnings and notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge of the largest cube face; an engine that filters by itself gets the probe at its own size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that will be written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Holds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bytes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files that will be written; levels show their roughness when pointed at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>as the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness of the levels: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ExportDialog</name>
    <message>
        <source>Environment as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specular, the material&apos;s lobe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse irradiance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roughness chain, ggx 0 to 1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Estimate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;lose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the written files in the file manager</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the maps that are checked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops; files that are not finished leave nothing behind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closes this window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancelled. Maps that were finished are there, the others left nothing behind.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The command line is on the clipboard.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The scene exports nothing yet. Add a map to begin.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No estimate yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No map is checked.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2 in all%3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name the folder that the files go to.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exporting ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wrote %1, %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2: about %3; %4 of texels before compression</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere map, as it is painted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; computed in less than 0.1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; computed in about %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to export for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An engine gets the scene&apos;s light as it takes it; below them, the maps that the scene lists itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not proven</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Maps of the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>chosen one by one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, about %2 in all</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ExportForm</name>
    <message>
        <source>six files, one a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coarser levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>one file a level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> texels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>down to one texel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters, digits, - and _; names the files and the description beside them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is written</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Parameterization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How directions become texels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge of a face, disc or octahedron, or height of a latlong; arrows double and halve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texels between a disc and the edge of the picture; Blender shows a matcap&apos;s outline whole with 2 at 512</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File format and what a texel is stored as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cube: px, nx, py, ny, pz and nz instead of one stack</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mip levels: each the halving of the one before, across seams; a painted map&apos;s as it makes them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Numbered files instead of one that holds all levels; %d in the file&apos;s name stands for the number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How many levels of roughness; each is filtered from the probe itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ile</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>File name; %s in a cube&apos;s stands for the six faces, %d for the number of a level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One file a level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Halved levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export parameterization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export levels</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ExportList</name>
    <message>
        <source>Maps to export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a map to the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds a copy of the selected map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Takes the selected map off the list; files on disk stay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material&apos;s sphere map, for programs that take matcaps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material has no sphere map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ExportPlace</name>
    <message>
        <source>Folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the files go; made when it is missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;older</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Choose...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Chooses the folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the same bytes without the studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Co&amp;mmand line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cop&amp;y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the command line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sa&amp;ve scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saves the scene, which the command line reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Writes the same bytes as Export.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The command line reads the saved scene: save it first, then both write the same bytes.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::FileActions</name>
    <message>
        <source>&amp;New scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start a new scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;as…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the scene under another name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open another…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrorball scenes (*.mirrorball)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save elsewhere…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the changes to %1?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>They are lost otherwise.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No files yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a scene, a light probe or another picture, a mesh, a sphere map or a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a sa&amp;mple</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1  (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scene to begin from; it has no file until it is saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A sphere map to begin from: it becomes the scene&apos;s own</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::FileOpener</name>
    <message>
        <source>%1: there is no such file; it may have been moved or renamed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: is nothing that can be opened here; choose a scene, a light probe or another picture, a folder of them, a mesh, a sphere map or a material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens %1 files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asks what %1 is: light or the picture of a ball</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light probe: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere map of the material: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Image layer: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder of light probes: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opens the %1 %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::FresnelCurve</name>
    <message>
        <source>Fresnel curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the light is mirrored (F), over the angle between the line of sight and the normal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F(%1°) = %2 %</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::GradientBar</name>
    <message>
        <source>Gradient stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag a stop to move it, pull it away to remove it; double-click for a new one</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::GradientEditor</name>
    <message>
        <source>Stop position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the chosen stop stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity of the chosen stop: below 100 % what lies under the layer shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color of the chosen stop</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::HelpActions</name>
    <message>
        <source>&amp;Help on this panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the guide at the page of the panel that has the keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What&apos;s this?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click anything next: the guide opens where it is explained</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The &amp;guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All pages of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every key of the studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tour of the studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Five steps from a light to maps for an engine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About Mirrorball Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrorball Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;Mirrorball Studio %1&lt;/b&gt;&lt;p&gt;Materials with environment maps.&lt;p&gt;GPL-3.0-or-later</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click what you want to know about; Escape ends this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Version and license</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::HelpWindow</name>
    <message>
        <source>Page of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pages of the guide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find in this page</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter finds the next place (Ctrl+F)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The page before (Alt+Left)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 - Mirrorball&apos;s guide</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ItemChooser</name>
    <message>
        <source>Add to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add one like the one chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the one chosen</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::LayerList</name>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The layers, the topmost first: drag to reorder, double-click to rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::LayerModel</name>
    <message>
        <source>, 1 stroke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 strokes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>masked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename layer</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::LayersPage</name>
    <message>
        <source>Blend mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the layer meets what lies below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change blend mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the layer shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change opacity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a layer above the chosen one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the chosen layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the chosen layer up (Ctrl+Up)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the chosen layer down (Ctrl+Down)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete the chosen layer (Delete)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No layers yet: add one with +.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This version does not know layers of the kind &quot;%1&quot;. It is kept as it is, and left out of the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Draw on the disc, or on the model.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::LevelsView</name>
    <message>
        <source>Levels of the mip chain</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making the levels ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Made level by level: a layer has its width in pixels, or levels of its own. Click a level to paint it alone.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Each level averages the one above. Click a level to paint it alone; a layer with a width in pixels is made for each, too.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click or Escape: show all levels again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: show and paint this level alone, on the disc and on the model</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::LobeErrorPanel</name>
    <message>
        <source>Lookups: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Errors of the lookups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rel_rms by angle of view, in degrees: 0.01 is a hundredth of the light, all over the sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the command line that measures the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material is measured once it has come to rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error over angle of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How far the light that lookups give is from the integral of the BRDF over the probe, by the angle between surface normal and view; further down is more accurate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rel_rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>angle of view, degrees</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material has no BRDF: its specular lobe is the round one that the map holds. Choose a BRDF in the Material panel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The probe is too large to be held whole; the command line measures it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring %1…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lookups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: error against the sum over every texel of the probe, averaged to %2 rows.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MainWindow</name>
    <message>
        <source>Picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export maps…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the maps of the scene, or copy the command line that does</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save &amp;picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture as PNG, or its radiance as EXR</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command &amp;palette…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Hide or show all docks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tab on the picture, F9 anywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Full screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose another…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the teapot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a scene without a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrorball ended before %1 was saved. Its changes of %2 were kept.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Restore</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] - Mirrorball Studio</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display picture (%1);;Linear radiance (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 holds %2 levels: it may be a map that was filtered already.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is this map?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brings the dock to the front, or closes it where it is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;What is this map?…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tell what a prefiltered map of anyone is: orientation, roughness law, lobe, scale, errors and faults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>P&amp;references…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys of commands, drags in the picture, how soon unsaved changes are kept</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MapLayoutRow</name>
    <message>
        <source>Parameterization</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How directions become texels: of the scene&apos;s map, and of what is shown here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the same map in another parameterization with as many texels, and the difference of both</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>beside %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edge of a face, disc or octahedron, or height of a latlong, in texels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paraboloid: texels kept free outside each disc</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map border</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MapLook</name>
    <message>
        <source>Colors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a display shows it, or luminance in false colors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>False color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the parameterization does to texels, laid over the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No overlay</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solid angle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anisotropy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Directions: latitudes and longitudes every 15 degrees, and the axes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seams</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where faces, halves and edges of the map meet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the whole map (0 in the map)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness of the map here; in false colors it moves the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MapPanel</name>
    <message>
        <source>Map to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference of both maps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texel under the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which map of the scene is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specular: reflection, filtered</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse: irradiance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error of a method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level of the mip chain; 0 is the largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The maps are being made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This map is left out: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This map is not made.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No method is picked. Click a point in the Report panel to see the signed error of its map here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The probe is too large to hold: it was filtered while it was read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing in the scene needs the probe, so it was not read.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Point at the map to read a texel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R %1  G %2  B %3   L %4
texel %5, %6   direction %7  %8  %9   lon %10  lat %11</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> of a %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 against %2: rel_rms %3, largest %4 × rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, shown at %1%</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the texel&apos;s values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the view as a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MapView</name>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel or + and -: zoom. Drag or arrow keys: move. Double click or 0: fit. 1: a texel on a pixel. Shift and arrow keys: point at a texel.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MaskEditor</name>
    <message>
        <source>Inverted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where the layer shows: everywhere, or where a picture of this kind is bright or there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None: everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mask by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Luminance: where the mask is bright; opacity: where it is there</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Inverted mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the layer where the mask does not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Invert the mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on the mask</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strokes go to the mask instead of the layer; erasing takes them away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The largest level of the mip chain that the layer takes part in; 0 is the full size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smallest level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The smallest level of the mip chain that the layer takes part in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the mask</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MaterialPanel</name>
    <message>
        <source>Water</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Glass</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diamond</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start from a built-in material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Materials and scenes (*.material *.json *.mirrorball);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the material of a material or scene file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save this material as a file of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reflection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lambda</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>LOD bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fresnel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Index of refraction %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Custom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose metal</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Diffuse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Combine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At grazing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lookup in the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Coarser levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mip filtering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>untitled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sphere map is shown in place of this material: nothing below changes the picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lay it over the material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Uses the sphere map over the reflecting material; the Sphere map dock has the other uses</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change use of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lobe that knows the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BRDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lookups</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none: a model or a measured file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clear coat</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normal map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normals</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MethodChart</name>
    <message>
        <source>Error against run time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A point is a method with one setting: further left is faster, further down more accurate. Click one to pick it; the table below does the same.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 %2
%3 s, rel_rms %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rel_rms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::MethodTable</name>
    <message>
        <source>refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>too slow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rel_rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picks the method of a row; refused and slow ones say why when pointed at</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ModelPainter</name>
    <message>
        <source>radius %1, hardness %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::NoticePanel</name>
    <message>
        <source>Notices</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is wrong, and what to do about it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close this notice</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::NumberField</name>
    <message>
        <source>%1. Double-click to reset.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Arrow keys step; Shift: finer, Ctrl: coarser.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::OptionsForm</name>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>automatic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PaintTools</name>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase what was painted on this layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smudge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push what was painted on this layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick a color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pick a color from the map; Alt does it with every tool</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on the model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint on the model in the preview; Alt and left drag then turns it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Color of the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symmetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeat strokes around the center, or mirror them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror left and right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror top and bottom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirror both ways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 times around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint. A pen&apos;s pressure and its tilt count; its eraser end erases</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PaintedExport</name>
    <message>
        <source>Export the picture of the sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, 8 bit (*%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, linear light (*%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 with all mip levels (*%2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PictureBadges</name>
    <message>
        <source>Colors of the paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level that is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files shown as they were</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors as painted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sphere map is shown in the colors that were painted. Click to see it through the filmic curve, as light.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colors through a tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sphere map is shown as light, through the tone curve: its colors are not those that were painted. Click to see those.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every lookup reads this level of the sphere map, whatever its size on the screen, and strokes go to it alone. Click, or press Escape, to show all levels.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As last read: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1
The picture shows what was read before. It follows when the file is there again; click to look now.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PictureInspector</name>
    <message>
        <source>Histogram of the display values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clipped: looking…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % above 1, %2 % below 0</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PictureQuestion</name>
    <message>
        <source>Reading the picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is this picture?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is square: it may be the light of a place, or the picture of a ball. Choose what looks right.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leaves the scene as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light: the environment looks like this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A ball: the material looks like this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the file as this kind of map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material looks like the ball; the picture stays in its file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>image layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A layer of the sphere map that the scene has</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PlanView</name>
    <message>
        <source>Stages of the plan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture needs, what is left out and why, and how long each stage took</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plan appears with the first picture.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kept</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last update: %1. Left out: %2 of %3 stages.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PreferencesDialog</name>
    <message>
        <source>&amp;Reset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;No key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a command or a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows the commands that have these letters in their name or their keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a command, then press its new key in the field below</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Menu</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press the key that the chosen command is to have</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the chosen command the key that it has at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Leave the chosen command without a key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset &amp;all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give every command the key that it has at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New &amp;key</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which drags in the picture move the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the environment by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which drag in the picture turns the environment; it goes before the camera&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The wheel zooms. While a sphere map is painted on the model, left paints and right changes the brush; with Alt they move the camera.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep unsaved changes after</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How long after a change a copy of the scene is kept, which is offered again if the program or the machine stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 belongs to &quot;%2&quot;: give that another key first</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PresetGallery</name>
    <message>
        <source>Find a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows only presets whose names or descriptions hold these letters; Enter takes the one at hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a preset, or press Enter on it, to take it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No preset has these letters in its name or description.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::PreviewWidget</name>
    <message>
        <source>Preview</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag to orbit, middle drag to pan, wheel to zoom, Shift and right drag to turn the environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame the object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orbit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset exposure</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ProbeDelegate</name>
    <message>
        <source>cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ProbeDetails</name>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1 stops)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>kind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>luminance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sun</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the brightest 0.01 % hold %1 % of the energy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>texels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>note</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>half float</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 value beyond 65504</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 values beyond 65504</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Facts of the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading the probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the file shows the sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reading ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The shape fits several kinds. The right one has a level horizon and straight verticals:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read as %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finds a mirror ball in the photograph and reads it as a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads the file as this kind of map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read probe as</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (built in)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ProbesPanel</name>
    <message>
        <source>Probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Which probes are listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lists only probes whose names hold these letters</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Adds image files or a whole folder; dropping them on the window does the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folder...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a folder of probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Files...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this folder from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Built in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Single files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No probe here has &quot;%1&quot; in its name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No single files yet. Drop an .hdr or .exr file anywhere on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The folder %1 is gone. Remove it from the list, or put it back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This folder holds no .hdr, .exr or other image files.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a probe, or press Enter on it, to light the scene with it; Delete takes a single file off the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the selected file from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove missing files from the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light the scene with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read its picture anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is this map?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy its path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open its folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove from the list</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ReportPanel</name>
    <message>
        <source>Measure &amp;again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use it anyway</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measures every method anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops measuring; what is measured stays</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copies the command line that makes the picked method&apos;s map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filters the scene by this method though it takes long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mip filtering</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest kernel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Methods are measured once the material has come to rest.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped after %1 points.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material is a mirror: its map is the environment itself, and no method filters it. Choose Phong or GGX to compare methods.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no probe in memory to measure with.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Summing the reference for %1 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 into a %2 of size %3: %4 settings measured.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measuring %1 ... (about %2 for all settings)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (ran %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filtering method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> At the size of the scene&apos;s map it takes about %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: method minus reference, rel_rms %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 for the whole map, by which the others are judged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Facts of the chosen method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Kernels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Half</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Border</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest error of the map, rel_rms, that spectral, direct and hierarchical keep and auto plans for</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tolerance of the filter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (predicted %2), rel_rms %3 (predicted %4), largest %5 × rms. Its signed error is in the Map panel.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SettingsForm</name>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose one that is built in</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::Snapshots</name>
    <message>
        <source>Snapshot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>measuring…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rel_rms %1, PSNR %2 dB, SSIM %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SnapshotsPanel</name>
    <message>
        <source>Snapshots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen one is A, which is compared with what is shown now; F2 renames it, Delete takes it off the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the chosen snapshot, A, is compared with what is shown now, B</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Off</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the display values (sRGB, 0 to 1) of the two pictures as they are shown, A being the reference: relative root mean square, peak signal to noise, structural similarity of the luma</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the scene what the chosen snapshot keeps, seen from where the camera is now; undo takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the chosen snapshot another name (F2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the chosen snapshot off the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No snapshot is kept: Ctrl+K keeps what is shown, to be compared with what comes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe, side by side and difference say how far B is from A.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring back %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SphereMapCanvas</name>
    <message>
        <source>Sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This scene has no sphere map of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>radius %1, hardness %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SphereMapEditor</name>
    <message>
        <source>Add layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Delete layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a paint layer to paint on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a paint layer, or add one, to paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen layer is hidden; show it to paint on it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Erase</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Smudge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paint</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Paste layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level %1 only: %2 x %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SphereMapForm</name>
    <message>
        <source>Lookup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Space</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looked up per</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Resolution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flecks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change the sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change index</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looked up by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shape</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SphereMapPanel</name>
    <message>
        <source>A sphere map paints the look of the material by hand: one picture of a ball, in layers, shown live on the model.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give the material a sphere map of its own, to paint and layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start from a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brush</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole disc (Home)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New, presets, open, save, remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere maps (*.spheremap)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy a sphere map or recorded strokes from a file into the scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link a file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a sphere map, or a picture of one, that stays in its file and follows it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Link a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the map is made of</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is painted with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The mip chain, level by level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the map is looked up, its size, flecks, and what it is called</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit a copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy it into the scene, to paint and layer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the material without a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Presets...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material shows %1, which stays in its file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The material shows the preset %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the picture...</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SphereMapSourceField</name>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a sphere map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a preset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere maps and pictures of them (*.spheremap %1);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::SphereMapUseRow</name>
    <message>
        <source>Use of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change use of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opacity of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much of the map shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change opacity of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Surface color below the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change surface color</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::Tour</name>
    <message>
        <source>Choose a light: click a probe at the left, or drop an .hdr or .exr file on the window.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the light: hold Shift and drag with the right button in the picture, or drag &quot;Turn&quot; in the View dock.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a material: another preset, or change lobe, exponent or Fresnel.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the kind of the map that the engine will read: a dual paraboloid, a cube, an octahedron.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the maps: File &gt; Export maps (Ctrl+E), choose an engine or add maps, then Export.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show me</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brings the place to the front</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Skip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Goes on without doing this step</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the tour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help &gt; Tour of the studio begins it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tour, step %1 of %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ViewActions</name>
    <message>
        <source>Change geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Teapot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Torus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sphere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wireframe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Texture coordinates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seams of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mip levels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Frame the object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bring the object back to the middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset the view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The camera as it was at first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure half a stop up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Darker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure half a stop down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment, blurred</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>None</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep a &amp;snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this material and light to compare with</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;how the snapshot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the snapshot; hold B to glance at it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot on the left, now on the right; drag the line</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Difference</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Difference to the snapshot, four times as bright</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Compare</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the picture shows: the material, or what it is computed from</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Projection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Perspective or orthographic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What stands behind the object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dragging so turns the environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shift and right drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl and left drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl and middle drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Turn the environment by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Window of a room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Interpolate texture coordinates at vertices, as in 1999</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks sphere maps up between the vertices of the mesh, as the hardware of the papers did; otherwise at every pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change lookup</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Ctrl+Z takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure %1 EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Normals as lines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounding box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reset e&amp;xposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure back to 0 EV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One color</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Si&amp;de by side</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Snapshot on the left and now on the right, each whole</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dragging so moves the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pixel &amp;values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tell the light, display value, direction and level of the pixel under the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Histogram</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show how often each display value occurs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Clipping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mark where exposed light is above 1, red, or below 0, blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Inspect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Move the camera by</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::ViewPanel</name>
    <message>
        <source>Open mesh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tessellation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Environment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Brightness</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Latitude</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Roll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Field of view</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture width</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture height</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mesh file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change geometry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sRGB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>OpenColorIO file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open OpenColorIO configuration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Change %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Outside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Behind it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Farthest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Far depth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dithering</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>mirrorball::studio::WorkStatus</name>
    <message>
        <source>State of the work</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the work in the background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the work in the background (Esc)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saving the picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making maps…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not made: the notice above the picture says why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to date. Drawn in %1 ms at %2 × %3</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
