package robotran.textediting.code

import robotran.brick.kind.BrickKind
import robotran.textediting.text.TextLines

/** The brick that the imports of a Java program name; [otherwise] if none does. */
fun brickOfJava(lines: TextLines, otherwise: BrickKind): BrickKind {
    for (line in 0..<minOf(lines.count, MAX_LINES)) {
        val words = lines.line(line).trimStart()
        if (!words.startsWith("import ")) continue
        val name = words.removePrefix("import ").trimStart()
        if ('.' in name) BrickKind.ofJavaRoot(name.substringBefore('.'))?.let { return it }
    }
    return otherwise
}

/** Imports stand at the beginning. */
private const val MAX_LINES = 200
