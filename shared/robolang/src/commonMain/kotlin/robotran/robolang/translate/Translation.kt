package robotran.robolang.translate

import robotran.brick.kind.BrickKind

/**
 * A Robolang program as Java for a real brick: for leJOS on an RCX, for leJOS NXJ on an NXT.
 *
 * @property className the name of its public class; its file is [fileName].
 * @property java the whole text, with `
 * ` line ends.
 * @property lineMap maps its lines to those of the program.
 */
class Translation internal constructor(
    val className: String,
    val java: String,
    val lineMap: LineMap,
    val brick: BrickKind,
) {
    val fileName: String get() = "$className.java"
}
