package robotran.build.wasm

import org.gradle.api.Action
import org.gradle.api.GradleException
import org.gradle.api.Task
import org.jetbrains.kotlin.gradle.targets.js.ir.KotlinJsIrLink

/**
 * Empties functions of the linked app that pupils have no use for, so that binaryen removes what only these need. R8
 * does the same for Android by the rules that come with Compose. Kotlin's linker and binaryen know no such rules.
 *
 * These are the calls that tell a profiler and Compose's tools where in the source something is composed, and the
 * texts of Material in 80 languages that the app does not speak, instead of which it gets the English ones. It also
 * shortens strings that only tell functions apart.
 *
 * @param wasmName the file to change, in the folder of the task.
 */
internal class StubFunctions(private val wasmName: String) : Action<Task> {
    /** Replaces the wasm that [task], a [KotlinJsIrLink], has just linked. */
    override fun execute(task: Task) {
        val wasm = (task as KotlinJsIrLink).destinationDirectory.file(wasmName).get().asFile
        wasm.writeBytes(stub(WasmModule.read(wasm.readBytes())).bytes())
    }

    companion object {
        private const val RUNTIME = "androidx.compose.runtime"
        private const val TEXTS = "androidx.compose.material3.l10n"

        /** Functions without a result. */
        private val ACTIONS = listOf(
            "sourceInformation",
            "sourceInformationMarkerStart",
            "sourceInformationMarkerEnd",
            "traceEventStart",
            "traceEventEnd",
        ).map { "$RUNTIME.$it" }
        private const val CONDITION = "$RUNTIME.isTraceInProgress"
        private const val ENGLISH = "en"

        /** The languages of the app, as in the table of `shared/language`. */
        private val LANGUAGES = listOf(ENGLISH, "es", "de", "fr", "pt")

        /** Chooses the texts of a language. */
        private const val CHOICE = "translationFor"

        /** What stays as it is. */
        private val KEPT = (LANGUAGES + CHOICE).map { "$TEXTS.$it" }

        /**
         * Functions that make the string of a literal and remember it. Without a hint, binaryen keeps their calls,
         * since they write to memory.
         */
        private val LITERALS = listOf("_stringLiteralJsString", "_stringLiteralLatin1", "_stringLiteralUtf16")

        /** The module from which string constants are imported, and how those begin that tell functions apart. */
        private const val STRINGS = "'"
        private const val SIGNATURE = "[ File '"

        private const val REMOVABLE = "binaryen.removable.if.unused"
        private const val ONE_HINT = 1
        private const val AT_FUNCTION = 0
        private const val NO_CONTENT = 0

        private val NOTHING = byteArrayOf(0, 0x0b)
        private val NEVER = byteArrayOf(0, 0x41, 0, 0x0b)

        /** [module], which must name its functions, with those emptied. */
        fun stub(module: WasmModule): WasmModule {
            val names = functionNames(module)
            val spoken = names.entries.filter { it.value in KEPT }.associate {
                it.value.substringAfterLast('.') to
                    it.key
            }
            val missing = (ACTIONS + CONDITION + KEPT + LITERALS) - names.values.toSet()
            if (missing.isNotEmpty()) {
                throw GradleException("The linked app has no function ${missing.joinToString()}: see StubFunctions.")
            }
            val first = module.importedFunctions
            val bodies = module.bodies.mapIndexed { index, body ->
                bodyOf(names[first + index].orEmpty(), spoken) ?: body
            }
            val code = WasmModule.vector(bodies.map { WasmWriter().sized(it).bytes() })
            val imports = shortSignatures(module.imports).map { it.bytes() }
            val replaced = mapOf(WasmModule.CODE to code, WasmModule.IMPORT to WasmModule.vector(imports))
            return module.with(replaced) + removable(names.filterValues { it in LITERALS }.keys)
        }

        /**
         * Kotlin compares references of functions and properties by a string with the path of the source on the machine
         * that has built the app. A number does as well.
         */
        fun shortSignatures(imports: List<WasmImport>): List<WasmImport> {
            val numbers = mutableMapOf<String, Int>()
            return imports.map { import ->
                if (import.module != STRINGS || !import.name.startsWith(SIGNATURE)) return@map import
                val number = numbers.getOrPut(import.name) { numbers.size }
                WasmImport(import.module, "$SIGNATURE$number", import.space, import.type)
            }
        }

        /** The section that allows binaryen to remove calls of [functions] whose results nobody uses. */
        private fun removable(functions: Set<Int>): WasmSection {
            val hints = functions.sorted().map { function ->
                WasmWriter().number(function).byte(ONE_HINT, AT_FUNCTION, NO_CONTENT).bytes()
            }
            return WasmSection(WasmModule.CUSTOM, WasmWriter().name(REMOVABLE).raw(WasmModule.vector(hints)).bytes())
        }

        /**
         * The new body of the function [name], where [spoken] are the functions with the texts of the app's languages by
         * their tags; null if it stays as it is. A country's variant has the texts of its language.
         */
        fun bodyOf(name: String, spoken: Map<String, Int>): ByteArray? = when {
            name in ACTIONS -> NOTHING
            name == CONDITION -> NEVER
            name.startsWith("$TEXTS.") && name !in KEPT -> {
                val language = name.substringAfterLast('.').takeWhile { it.isLowerCase() }
                callOf(spoken[language] ?: spoken.getValue(ENGLISH))
            }

            else -> null
        }

        /** The body of a function that passes its only parameter to [function] and returns its result. */
        private fun callOf(function: Int): ByteArray =
            WasmWriter().byte(0, 0x20, 0, 0x10).number(function).byte(0x0b).bytes()
    }
}
