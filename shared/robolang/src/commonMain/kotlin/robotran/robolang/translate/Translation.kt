package robotran.robolang.translate

/**
 * A Robolang program as leJOS Java for a real RCX.
 *
 * @property className the name of its public class; its file is called [fileName].
 * @property java the whole text, its lines ending in `\n`.
 * @property lineMap which of its lines came from which line of the program.
 */
class Translation internal constructor(val className: String, val java: String, val lineMap: LineMap) {
    val fileName: String get() = "$className.java"
}
