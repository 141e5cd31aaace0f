package robotran.robolang.translate

import robotran.brick.kind.BrickKind

/**
 * One file of a kit.
 *
 * @property path its path in the kit, with `/` as separator.
 * @property text its content, encoded as UTF-8.
 * @property isExecutable whether it is executable, on systems with that attribute.
 */
data class KitFile(val path: String, val text: String, val isExecutable: Boolean = false)

/**
 * The files to bring a program onto a real brick, an RCX with leJOS 2.1 or 3.0 or an NXT with leJOS NXJ 0.9: the Java,
 * its Robolang source, instructions, an Ant build file, and scripts for a Unix shell and for Windows.
 *
 * @param sourceName the name of the Robolang file, without folders.
 * @param source its text.
 */
fun kitFiles(translation: Translation, sourceName: String, source: String): List<KitFile> {
    val className = translation.className
    val program = listOf(
        KitFile("$className/${translation.fileName}", translation.java),
        KitFile("$className/$sourceName", source),
    )
    return program +
        KitTools(className, className, listOf(translation.fileName), sourceName).filesFor(translation.brick)
}

/**
 * The same for a program written in Java: its sources, instructions, the build file and the scripts.
 *
 * @param mainClass its main class, with slashes after the parts of its package.
 * @param sources its files by name; folders in names are dropped.
 * @param brick that the program is for.
 */
fun javaKitFiles(mainClass: String, sources: List<KitFile>, brick: BrickKind): List<KitFile> {
    val className = mainClass.substringAfterLast('/')
    val names = mutableListOf<String>()
    for (source in sources) names += uniqueName(plainName(source.path), names)
    val files = names.zip(sources) { name, source -> KitFile("$className/$name", source.text) }
    return files + KitTools(className, mainClass.replace('/', '.'), names, null).filesFor(brick)
}

/** The name of a source without characters that are special to a shell; a public class's name has none. */
private fun plainName(path: String): String {
    val name = path.substringAfterLast('/').substringAfterLast('\\').removeSuffix(JAVA)
    return name.map {
        if (it.isLetterOrDigit() || it == '_' || it == '$') {
            it
        } else {
            '_'
        }
    }.joinToString("").ifEmpty { "_" } +
        JAVA
}

private fun uniqueName(name: String, others: List<String>): String =
    (listOf(name) + (2..others.size + 1).map { name.removeSuffix(JAVA) + "_$it" + JAVA }).first { it !in others }

private const val JAVA = ".java"
