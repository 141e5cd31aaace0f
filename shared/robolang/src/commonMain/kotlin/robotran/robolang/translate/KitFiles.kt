package robotran.robolang.translate

/**
 * One file of a kit.
 *
 * @property path where it lies in the kit, folders separated by `/`.
 * @property text its content, in UTF-8.
 * @property isExecutable whether it is a program itself, for systems that ask.
 */
data class KitFile(val path: String, val text: String, val isExecutable: Boolean = false)

/**
 * All that is needed to bring a program onto a real RCX with leJOS 2.1 or 3.0 installed: the Java, the Robolang it came
 * from, a page that says what to do, a build file for Ant and the same as scripts for a shell and for Windows.
 *
 * @param sourceName the name of the Robolang file, without folders.
 * @param source its text.
 */
fun kitFiles(translation: Translation, sourceName: String, source: String): List<KitFile> {
    val className = translation.className
    val scripts = KitScripts(className, className, listOf(translation.fileName))
    return listOf(
        KitFile("$className/${translation.fileName}", translation.java),
        KitFile("$className/$sourceName", source),
        KitFile("$className/README.txt", KitTexts.readme(className, sourceName)),
    ) + filesOf(scripts, className)
}

/**
 * The same for a program that its pupil has written in Java: its sources, the page, the build file and the scripts.
 *
 * @param mainClass the class that it begins with, with slashes after the parts of its package.
 * @param sources its files by their names, with or without folders, which the kit does without.
 */
fun javaKitFiles(mainClass: String, sources: List<KitFile>): List<KitFile> {
    val className = mainClass.substringAfterLast('/')
    val names = mutableListOf<String>()
    for (source in sources) names += uniqueName(plainName(source.path), names)
    val scripts = KitScripts(className, mainClass.replace('/', '.'), names)
    val files = names.zip(sources) { name, source -> KitFile("$className/$name", source.text) }
    return files + KitFile("$className/README.txt", KitTexts.javaReadme(className)) + filesOf(scripts, className)
}

private fun filesOf(scripts: KitScripts, className: String): List<KitFile> = listOf(
    KitFile("$className/build.xml", scripts.antFile()),
    KitFile("$className/download.sh", scripts.shellScript(), isExecutable = true),
    KitFile("$className/download.bat", scripts.batchFile().replace("\n", "\r\n")),
)

/**
 * The name of a source with nothing in it that a shell takes for something else; that of a public class has nothing
 * such anyway.
 */
private fun plainName(path: String): String {
    val name = path.substringAfterLast('/').substringAfterLast('\\').removeSuffix(JAVA)
    return name.map {
        if (it.isLetterOrDigit() || it == '_' ||
            it == '$'
        ) {
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
