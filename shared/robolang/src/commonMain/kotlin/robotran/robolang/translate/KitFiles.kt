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
 * All that is needed to bring a program onto a real RCX with leJOS 2.1 or 3.0 installed: the Java, the Robolang it came from, a page that
 * says what to do, a build file for Ant and the same as scripts for a shell and for Windows.
 *
 * @param sourceName the name of the Robolang file, without folders.
 * @param source its text.
 */
fun kitFiles(
    translation: Translation,
    sourceName: String,
    source: String,
): List<KitFile> {
    val className = translation.className
    return listOf(
        KitFile("$className/${translation.fileName}", translation.java),
        KitFile("$className/$sourceName", source),
        KitFile("$className/README.txt", KitTexts.readme(className, sourceName)),
        KitFile("$className/build.xml", KitTexts.antFile(className)),
        KitFile("$className/download.sh", KitTexts.shellScript(className), isExecutable = true),
        KitFile("$className/download.bat", KitTexts.batchFile(className).replace("\n", "\r\n")),
    )
}
