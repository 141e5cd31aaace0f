package robotran.javacompiler

import robotran.ecj.EcjCompiler
import robotran.ecj.Library
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.messages.JavaMessages
import robotran.languagesupport.SourceFile

actual suspend fun loadJavaCompiler(messages: JavaMessages): JavaCompiler = JavaCompiler(JvmEcj(), messages)

internal class JvmEcj : Ecj {
    private class LoadedLibrary(val classFiles: Map<String, ByteArray>) {
        val library = Library().apply { classFiles.forEach { (name, bytes) -> add(name, bytes) } }
    }

    private val loaded = mutableMapOf<BrickTarget, LoadedLibrary>()

    override fun compile(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation = synchronized(LOCK) { compileAlone(sources, library, gaps, target) }

    private fun compileAlone(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation {
        val known = loaded[target]?.takeIf { it.classFiles === library }
            ?: LoadedLibrary(library).also { loaded[target] = it }
        val compiler = EcjCompiler(known.library, robotran.ecj.BrickTarget.entries[target.ordinal])
        gaps.forEach(compiler::addGap)
        sources.forEach { compiler.addSource(it.name, it.text) }
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

    private companion object {
        /** ECJ counts its work in one place, so it compiles one program at a time. */
        val LOCK = Any()
    }
}
