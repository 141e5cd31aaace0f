package robotran.build.teavm

import org.gradle.api.DefaultTask
import org.gradle.api.file.ConfigurableFileCollection
import org.gradle.api.file.DirectoryProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Classpath
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFiles
import org.gradle.api.tasks.OutputDirectory
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.workers.WorkerExecutor
import javax.inject.Inject

/**
 * Compiles Java class files with TeaVM to Wasm GC. [outputFolder] then holds `NAME.wasm`, TeaVM's loader
 * `NAME-runtime.mjs` and `NAME.mjs`, whose `loadModule()` returns the exported functions.
 */
@CacheableTask
abstract class CompileToWasm : DefaultTask() {
    /** TeaVM and its dependencies, isolated from Gradle's classpath. */
    @get:Classpath
    abstract val compiler: ConfigurableFileCollection

    /** The classes to compile, with TeaVM's class library. */
    @get:Classpath
    abstract val program: ConfigurableFileCollection

    /** The class whose exported static methods the module offers. */
    @get:Input
    abstract val mainClass: Property<String>

    @get:Input
    abstract val moduleName: Property<String>

    /**
     * The names of exported WebAssembly functions (TeaVM's `Export`) that `NAME.mjs` exports too, for other WebAssembly
     * modules to import. It then loads the module as soon as it is imported.
     */
    @get:Input
    abstract val wasmFunctions: ListProperty<String>

    /**
     * Whether null and out-of-bounds accesses throw catchable exceptions, as in Java, instead of terminating the
     * module.
     */
    @get:Input
    abstract val strict: Property<Boolean>

    /**
     * The name of a `TeaVMOptimizationLevel`. `FULL` also inlines small methods: faster in inner loops; for a large
     * program twice the size and half a minute more to compile.
     */
    @get:Input
    abstract val optimizationLevel: Property<String>

    /** Scripts that import the module, put beside it. */
    @get:InputFiles
    @get:PathSensitive(PathSensitivity.NAME_ONLY)
    abstract val scripts: ConfigurableFileCollection

    @get:OutputDirectory
    abstract val outputFolder: DirectoryProperty

    @get:Inject
    abstract val workers: WorkerExecutor

    @TaskAction
    fun compile() {
        workers.classLoaderIsolation { it.classpath.from(compiler) }.submit(CompileToWasmAction::class.java) {
            it.program.from(program)
            it.mainClass.set(mainClass)
            it.moduleName.set(moduleName)
            it.strict.set(strict)
            it.optimizationLevel.set(optimizationLevel)
            it.wasmFunctions.set(wasmFunctions)
            it.scripts.from(scripts)
            it.outputFolder.set(outputFolder)
        }
    }
}
