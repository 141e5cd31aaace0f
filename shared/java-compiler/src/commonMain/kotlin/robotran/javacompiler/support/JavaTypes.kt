package robotran.javacompiler.support

import robotran.languagesupport.SourceFile
import robotran.languagesupport.simpleName

/**
 * The same file, called like the class in it. A file without a class is called [stem]; all stay in their folders.
 */
internal fun namedByClass(file: SourceFile, stem: String): SourceFile {
    val types = javaTypes(file.text)
    val name = types.firstOrNull { it.isPublic }?.name ?: stem.takeIf { types.any { type -> type.name == it } }
        ?: types.firstOrNull()?.name ?: stem
    return file.copy(name = "${file.name.removeSuffix(simpleName(file.name))}$name.java")
}

/** Whether a program can start in the Java source [text]. */
internal fun hasMain(text: String): Boolean = MAIN in text

private class JavaType(val name: String, val isPublic: Boolean)

/** The types that are declared in [text] outside of others. */
private fun javaTypes(text: String): List<JavaType> {
    val types = mutableListOf<JavaType>()
    var depth = 0
    var isPublic = false
    var before = ""
    for (word in javaWords(text)) {
        when {
            word == "{" -> depth++

            word == "}" -> {
                depth--
                isPublic = false
            }

            depth > 0 -> Unit
            word == ";" -> isPublic = false
            word == "public" -> isPublic = true
            before in DECLARATIONS -> types += JavaType(word, isPublic)
        }
        before = word
    }
    return types
}

private val DECLARATIONS = setOf("class", "interface", "enum")
private val MAIN = Regex("\\bvoid\\s+main\\s*\\(")
