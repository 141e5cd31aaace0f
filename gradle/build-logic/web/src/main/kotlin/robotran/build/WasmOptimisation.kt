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
    /** The Gradle property with the passes for the tested page, separated by spaces: they take little time. */
    const val TEST_PASSES = "robotran.wasmPasses"

    /** The Gradle property with the passes for what pupils get: small and fast. */
    const val RELEASE_PASSES = "robotran.releaseWasmPasses"

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

    /** What makes the messages of a language. Inlined where it is chosen, it would bring the messages of all languages along. */
    private const val MESSAGES = "*Messages.<init>*"

    /** Keeps the names of functions, by which [robotran.build.site.SplitWasm] divides the app; the parts have none. */
    private const val KEEP_NAMES = "-g"

    /** All arguments of binaryen's `wasm-opt` but the files; [property] names the passes. */
    fun arguments(project: Project, property: String): Provider<List<String>> =
        project.providers.gradleProperty(property).map { passes ->
            features.map { "--enable-$it" } +
                KEEP_NAMES +
                separate.map { "--no-inline=kotlin.wasm.internal.$it" } +
                "--no-inline=$MESSAGES" +
                passes.split(" ")
        }

    /** Makes Kotlin's plugin optimise with the passes of [property]. */
    fun use(project: Project, property: String) {
        val arguments = arguments(project, property)
        project.tasks.withType(BinaryenExec::class.java).configureEach { it.binaryenArguments.set(arguments) }
    }
}
