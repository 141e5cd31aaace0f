@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.javacompiler

import kotlinx.coroutines.await
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.JavaSource
import robotran.javacompiler.messages.JavaMessages

actual suspend fun loadJavaCompiler(messages: JavaMessages): JavaCompiler =
    JavaCompiler(WasmEcj(importEcjModule().await()), messages)

private class WasmEcj(private val module: EcjModule) : Ecj {
    private var known: Map<String, ByteArray>? = null

    override fun compile(sources: List<JavaSource>, library: Map<String, ByteArray>): EcjCompilation {
        read(library)
        sources.forEach { module.addSource(it.path, it.text) }
        val completed = module.compile()
        val names = List(module.classCount()) { module.className(it) }
        val classes = names.withIndex().associate { (place, name) -> name to byteArray(module.classFile(place)) }
        val mainClasses = names.filterIndexed { place, _ -> module.classHasMain(place) }
        return EcjCompilation(classes, mainClasses, List(module.problemCount(), ::problem), completed)
    }

    private fun read(library: Map<String, ByteArray>) {
        if (library === known) return
        module.clearLibrary()
        library.forEach { (name, bytes) -> module.addLibraryClass(name, bytes.toJsArray()) }
        known = library
    }

    private fun problem(place: Int) = EcjProblem(
        path = module.problemPath(place),
        number = module.problemNumber(place),
        isError = module.problemIsError(place),
        isSyntax = module.problemIsSyntax(place),
        start = module.problemStart(place),
        end = module.problemEnd(place),
        message = module.problemMessage(place),
        arguments = List(module.problemArgumentCount(place)) { module.problemArgument(place, it) },
        members = List(module.problemMemberCount(place)) { module.problemMember(place, it) },
    )
}
