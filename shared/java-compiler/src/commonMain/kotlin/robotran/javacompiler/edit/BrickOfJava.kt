package robotran.javacompiler.edit

import robotran.brick.kind.BrickKind
import robotran.languagesupport.TextLines

/** The brick that the imports of a Java program name; null if none does. */
internal fun brickOfJava(lines: TextLines): BrickKind? {
    for (line in 0..<minOf(lines.count, MAX_LINES)) {
        val words = lines.line(line).trimStart()
        if (!words.startsWith("import ")) continue
        val name = words.removePrefix("import ").trimStart()
        if ('.' in name) BrickKind.ofJavaRoot(name.substringBefore('.'))?.let { return it }
    }
    return null
}

/** Imports stand at the beginning. */
private const val MAX_LINES = 200
