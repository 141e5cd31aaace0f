package robotran.javacompiler

import robotran.ecj.EcjCompiler
import robotran.ecj.Library
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.JavaSource
import robotran.javacompiler.messages.JavaMessages

actual suspend fun loadJavaCompiler(messages: JavaMessages): JavaCompiler = JavaCompiler(JvmEcj(), messages)

private class JvmEcj : Ecj {
    private var loadedLibrary: Map<String, ByteArray>? = null
    private var library = Library()

    override fun compile(
        sources: List<JavaSource>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
    ): EcjCompilation {
        read(library)
        val compiler = EcjCompiler(this.library)
        gaps.forEach(compiler::addGap)
        sources.forEach { compiler.addSource(it.path, it.text) }
        val result = compiler.compile()
        val problems = result.problems().map {
            EcjProblem(
                it.path(),
                it.number(),
                it.error(),
                it.syntax(),
                it.start(),
                it.end(),
                it.message(),
                it.arguments(),
                it.members(),
            )
        }
        return EcjCompilation(result.classes(), result.mainClasses(), problems, completed = !result.crashed())
    }

    private fun read(classFiles: Map<String, ByteArray>) {
        if (classFiles === loadedLibrary) return
        library = Library()
        classFiles.forEach { (name, bytes) -> library.add(name, bytes) }
        loadedLibrary = classFiles
    }
}
