package robotran.build.site

import org.gradle.api.DefaultTask
import org.gradle.api.file.RegularFileProperty
import org.gradle.api.provider.ListProperty
import org.gradle.api.provider.Property
import org.gradle.api.tasks.CacheableTask
import org.gradle.api.tasks.Input
import org.gradle.api.tasks.InputFile
import org.gradle.api.tasks.Internal
import org.gradle.api.tasks.OutputFile
import org.gradle.api.tasks.PathSensitive
import org.gradle.api.tasks.PathSensitivity
import org.gradle.api.tasks.TaskAction
import org.gradle.process.ExecOperations
import robotran.build.WebTools
import javax.inject.Inject

/** Makes the app's wasm, as Kotlin has linked it, small and fast, which takes binaryen minutes. */
@CacheableTask
abstract class OptimizeWasm
    @Inject
    constructor(private val processes: ExecOperations) : DefaultTask() {
        @get:InputFile
        @get:PathSensitive(PathSensitivity.NONE)
        abstract val linked: RegularFileProperty

        /** The arguments of `wasm-opt` without files. */
        @get:Input
        abstract val arguments: ListProperty<String>

        @get:OutputFile
        abstract val optimized: RegularFileProperty

        @get:Internal
        abstract val wasmOpt: Property<String>

        init {
            dependsOn(":${WebTools.SET_UP_TASK}")
            wasmOpt.set(WebTools.wasmOpt(project).path)
        }

        @TaskAction
        fun optimize() {
            val files = listOf(linked.get().asFile.path, "-o", optimized.get().asFile.path)
            processes.exec { it.commandLine(listOf(wasmOpt.get()) + files + arguments.get()) }
        }
    }
