package robotran.robolang.translate

/**
 * A Robolang program as leJOS Java for a real RCX.
 *
 * @property className the name of its public class; its file is [fileName].
 * @property java the whole text, with `
 * ` line ends.
 * @property lineMap maps its lines to those of the program.
 */
class Translation internal constructor(val className: String, val java: String, val lineMap: LineMap) {
    val fileName: String get() = "$className.java"
}
