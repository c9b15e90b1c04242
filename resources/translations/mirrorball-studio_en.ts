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
</context>
<context>
    <name>main</name>
    <message>
        <source>Author materials with environment maps: the desktop tool.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A scene (.mirrorball), a light probe (.hdr, .exr, ...) or a mesh to open.</source>
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
        <source>Type a command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Command</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Letters of the command, in their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Commands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter or click runs the command</source>
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
        <source>%1: is neither an image nor a folder nor anything else that can be opened; drop .hdr, .exr or another image, or a folder of them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe</source>
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
        <source>six files, one a face</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>halved levels in the file</source>
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
        <source>Paraboloid: texels kept free outside each disc</source>
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
        <source>Mip levels, each the halving of the one before, across seams</source>
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
        <source>File name; %s in a cube&apos;s stands for the six faces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Six files</source>
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
    <message>
        <source>Export file</source>
        <translation type="unfinished"></translation>
    </message>
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
        <source>The command line is on the clipboard.</source>
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
        <source>%1, %2: about %3, of which %4 are texels before compression</source>
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
        <source>; filtered in less than 0.1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; filtered in about %1 s</source>
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
        <source>Open a scene file</source>
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
        <source>Open scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mirrorball scenes (*.mirrorball);;All files (*)</source>
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
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
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
        <source>Stopped</source>
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
        <source>Saving the picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Making maps…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up to date. Drawn in %1 ms at %2 × %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display picture (*.png);;Linear radiance (*.exr)</source>
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
    <message>
        <source>Colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a display shows it, or luminance in false colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>False colour</source>
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
        <source>Brightness of the map here; in false colours it moves the scale</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
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
        <source>%1 against %2: rel_rms %3, largest %4 of the mean square</source>
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
        <source>, shown at %1 %</source>
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
        <source>rel_rms against the reference</source>
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
</context>
<context>
    <name>mirrorball::studio::ProbesPanel</name>
    <message>
        <source>cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> (%1 stops)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a probe, or press Enter on it, to light the scene with it</source>
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
        <source>Images (*.exr *.hdr *.pic *.rgbe *.tif *.tiff *.tx *.png *.jpg *.jpeg);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove this folder from the list</source>
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
        <source>Reading ...</source>
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
        <source>The shape fits several kinds. The right one has a level horizon and straight verticals:</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read as %1</source>
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
    <name>mirrorball::studio::ReportPanel</name>
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
        <source>Methods</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Method</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Setting</source>
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
        <source>Picks the method of a row; refused and slow ones say why when pointed at</source>
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
        <source>Measuring %1 ...</source>
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
        <source>%1 (predicted %2), rel_rms %3 (predicted %4), largest %5 of the mean square. Its signed error is in the Map panel.</source>
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
        <source>One colour</source>
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
        <source>Meshes (%1);;All files (*)</source>
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
        <source>OpenColorIO (*.ocio);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
