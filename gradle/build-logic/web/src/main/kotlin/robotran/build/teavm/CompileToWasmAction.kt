package robotran.build.teavm

import org.gradle.api.GradleException
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.workers.WorkAction
import org.gradle.workers.WorkParameters
import org.teavm.tooling.ConsoleTeaVMToolLog
import org.teavm.tooling.TeaVMProblemRenderer
import org.teavm.tooling.TeaVMTargetType
import org.teavm.tooling.TeaVMTool
import org.teavm.vm.TeaVMOptimizationLevel
import java.io.File
import java.net.URLClassLoader

/** The part of [CompileToWasm] that uses TeaVM's classes. */
internal abstract class CompileToWasmAction : WorkAction<CompileToWasmAction.Parameters> {
    interface Parameters : WorkParameters {
        val program: ConfigurableFileCollection
        val mainClass: Property<String>
        val moduleName: Property<String>
        val strict: Property<Boolean>
        val optimizationLevel: Property<String>
        val wasmFunctions: ListProperty<String>
        val scripts: ConfigurableFileCollection
        val outputFolder: DirectoryProperty
    }

    override fun execute() {
        val folder = parameters.outputFolder.get().asFile
        val name = parameters.moduleName.get()
        folder.listFiles().orEmpty().forEach { it.deleteRecursively() }
        compile(folder, "$name.wasm")
        folder.resolve("$name-runtime.mjs").writeText(runtime())
        folder.resolve("$name.mjs").writeText(entry(name))
        parameters.scripts.forEach { it.copyTo(folder.resolve(it.name)) }
    }

    private fun compile(folder: File, fileName: String) {
        val log = ConsoleTeaVMToolLog(false)
        val tool = TeaVMTool()
        tool.targetType = TeaVMTargetType.WEBASSEMBLY_GC
        tool.mainClass = parameters.mainClass.get()
        tool.targetDirectory = folder
        tool.setTargetFileName(fileName)
        tool.optimizationLevel = TeaVMOptimizationLevel.valueOf(parameters.optimizationLevel.get())
        tool.setObfuscated(true)
        tool.setStrict(parameters.strict.get())
        tool.log = log
        val classPath = parameters.program.files.map { it.toURI().toURL() }
        URLClassLoader(classPath.toTypedArray(), TeaVMTool::class.java.classLoader).use {
            tool.classLoader = it
            tool.generate()
        }
        TeaVMProblemRenderer.describeProblems(tool.dependencyInfo.callGraph, tool.problemProvider, log)
        if (tool.problemProvider.severeProblems.isNotEmpty()) {
            throw GradleException("TeaVM could not compile ${parameters.mainClass.get()}.")
        }
    }

    /** TeaVM's loader as an ES module without `eval`. The comment keeps webpack from following its imports for Node. */
    private fun runtime(): String = CspSafeLoader.rewrite(
        resource(TeaVMTool::class.java, RUNTIME),
        resource(CompileToWasmAction::class.java, FUNCTIONS),
    )
        .replace("import(", "import(/* webpackIgnore: true */ ")

    /** The hand-written module that loads the other two and exposes their functions. */
    private fun entry(name: String): String {
        val functions = parameters.wasmFunctions.get()
        val entry = resource(CompileToWasmAction::class.java, ENTRY).replace("NAME", name)
        if (functions.isEmpty()) return entry
        return "$entry\nexport const { ${functions.joinToString()} } = (await loaded()).instance.exports;\n"
    }

    private fun resource(beside: Class<*>, path: String): String =
        checkNotNull(beside.classLoader.getResource(path)) { "There is no $path" }.readText()

    private companion object {
        const val RUNTIME = "org/teavm/backend/wasm/wasm-gc-module-runtime.js"
        const val FUNCTIONS = "robotran/build/teavm/without-eval.mjs"
        const val ENTRY = "robotran/build/teavm/module.mjs"
    }
}
