@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.javacompiler

import kotlinx.coroutines.await
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.messages.JavaMessages
import robotran.languagesupport.SourceFile

actual suspend fun loadJavaCompiler(messages: JavaMessages): JavaCompiler =
    JavaCompiler(WasmEcj(importEcjModule().await()), messages)

private class WasmEcj(private val module: EcjModule) : Ecj {
    private val loadedLibraries = mutableMapOf<BrickTarget, Map<String, ByteArray>>()

    override fun compile(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation {
        module.setTarget(target.ordinal)
        read(library, target)
        gaps.forEach { module.addGap(it) }
        sources.forEach { module.addSource(it.name, it.text) }
        val completed = try {
            module.compile()
        } catch (overflow: Throwable) {
            // The module's own handlers do not see the overflow of its stack.
            return EcjCompilation(emptyMap(), emptyList(), emptyList(), completed = false)
        }
        val names = List(module.classCount()) { module.className(it) }
        val classes = names.withIndex().associate { (index, name) -> name to byteArray(module.classFile(index)) }
        val mainClasses = names.filterIndexed { index, _ -> module.classHasMain(index) }
        return EcjCompilation(classes, mainClasses, List(module.problemCount(), ::problem), completed)
    }

    private fun read(library: Map<String, ByteArray>, target: BrickTarget) {
        if (library === loadedLibraries[target]) return
        module.clearLibrary()
        library.forEach { (name, bytes) -> module.addLibraryClass(name, bytes.toJsArray()) }
        loadedLibraries[target] = library
    }

    private fun problem(index: Int) = EcjProblem(
        path = module.problemPath(index),
        number = module.problemNumber(index),
        isError = module.problemIsError(index),
        isSyntax = module.problemIsSyntax(index),
        start = module.problemStart(index),
        end = module.problemEnd(index),
        message = module.problemMessage(index),
        arguments = List(module.problemArgumentCount(index)) { module.problemArgument(index, it) },
        members = List(module.problemMemberCount(index)) { module.problemMember(index, it) },
    )
}
