package robotran.build

import org.gradle.api.Project
import org.gradle.api.provider.Provider
import org.jetbrains.kotlin.gradle.targets.wasm.binaryen.BinaryenExec

/**
 * What binaryen does to the app and to what is measured in its place; docs/hosting.md says with which effect. Kotlin's
 * own choice takes several times as long and simplifies floating-point arithmetic (`--fast-math`), while runs are to be
 * the same everywhere to the last bit.
 */
internal object WasmOptimisation {
    /** The property of the build that names the passes, with spaces between them, so that others can be tried. */
    private const val PASSES = "robotran.wasmPasses"

    private val features =
        listOf(
            "gc",
            "reference-types",
            "exception-handling",
            "bulk-memory",
            "multivalue",
            "nontrapping-float-to-int",
            "stack-switching",
        )

    /** Kotlin's functions that its own code looks for by name. */
    private val separate = listOf("throwValue", "getKotlinException", "jsToKotlinStringAdapter")

    fun use(project: Project) {
        val passes: Provider<List<String>> = project.providers.gradleProperty(PASSES).map { it.split(" ") }
        project.tasks.withType(BinaryenExec::class.java).configureEach { task ->
            task.binaryenArguments.set(
                features.map {
                    "--enable-$it"
                } + separate.map { "--no-inline=kotlin.wasm.internal.$it" },
            )
            task.binaryenArguments.addAll(passes)
        }
    }
}
