package robotran.build

import org.gradle.api.Project
import org.gradle.api.provider.Provider
import org.jetbrains.kotlin.gradle.targets.wasm.binaryen.BinaryenExec

/**
 * The binaryen options for the app and the benchmarks; docs/hosting.md describes their effect. Kotlin's default options
 * take several times as long. They also simplify floating-point arithmetic (`--fast-math`), but runs must be
 * bit-identical everywhere.
 */
internal object WasmOptimisation {
    /** The Gradle property that overrides the passes, separated by spaces, for experiments. */
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

    /** Kotlin functions that Kotlin's generated code finds by name. */
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
