package robotran.learning

import robotran.brick.kind.BrickKind
import robotran.brick.kind.JavaPlatform

/**
 * Wraps [lines] of Java for a [brick], such as the example of a [WordHelp], in a whole program for the file `Try.java`.
 */
fun wrapJavaExample(lines: String, brick: BrickKind): String = buildString {
    for (name in importsFor(brick)) append("import $name.*;\n")
    append("\npublic class Try {\n    public static void main(String[] args) throws InterruptedException {\n")
    for (line in lines.trimEnd().lines()) append("        ").append(line).append('\n')
    append("    }\n}\n")
}

private fun importsFor(brick: BrickKind): List<String> = when (val java = brick.java) {
    JavaPlatform.LEJOS -> listOf(java.mainPackage)
    JavaPlatform.NXJ -> listOf(java.mainPackage, "lejos.robotics.navigation", "lejos.util")
    null -> emptyList()
}
