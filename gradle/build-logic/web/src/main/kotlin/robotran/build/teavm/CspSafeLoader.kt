package robotran.build.teavm

import org.gradle.api.GradleException

/**
 * Rewrites TeaVM's loader without `eval`, so that a content security policy may forbid it. TeaVM uses `eval` to give
 * functions the same number of parameters as in Java, which nothing here depends on, and for the few known scripts
 * inside Java code (`@JSBody`).
 */
internal object CspSafeLoader {
    /**
     * @param loader the readable `wasm-gc-module-runtime.js` of the TeaVM version in the version catalogue.
     * @param functions `without-eval.mjs` with the replacements of the evaluated code.
     */
    fun rewrite(loader: String, functions: String): String {
        var text = loader
        for ((start, end, replacement) in REPLACEMENTS) text = replaceOnce(text, start, end, replacement)
        if ("Function(" in text.replace("defineFunction(", "").replace("asFunction(", "")) {
            throw GradleException("TeaVM's loader makes code of texts in more places than CspSafeLoader knows.")
        }
        return functions + "\n" + text
    }

    /** Replaces the only section of the text from [start] to the next [end] by [replacement]. */
    private fun replaceOnce(text: String, start: String, end: String, replacement: String): String {
        val from = text.indexOf(start)
        val to = text.indexOf(end, from + start.length)
        if (from < 0 || to < 0 || text.indexOf(start, from + 1) >= 0) {
            throw GradleException("TeaVM's loader is another than CspSafeLoader knows: look for $start in it.")
        }
        return text.replaceRange(from, to + end.length, replacement)
    }

    private const val FUNCTION_OF_JAVA = "new Function(\n      \"rethrowJavaAsJs\""
    private const val METHOD_OF_JAVA = "new Function(\n        \"rethrowJavaAsJs\""
    private const val END_OF_IT = ")(rethrowJavaAsJs, fn);"

    private val REPLACEMENTS =
        listOf(
            Triple("new Function(\"return \" + name", ");", "() => globalNamed(name);"),
            Triple("new Function(\"value\", name", ")(value);", "globalThis[name] = value;"),
            Triple(
                "return $FUNCTION_OF_JAVA",
                END_OF_IT,
                "return handingOn(fn, params.length, vararg, rethrowJavaAsJs);",
            ),
            Triple("return new Function(\n      \"constructor\"", ")(c);", "return renamed(name, c);"),
            Triple("= $METHOD_OF_JAVA", END_OF_IT, "= handingOnWithThis(fn, params.length, vararg, rethrowJavaAsJs);"),
            Triple("new Function(\n      \"wrapCallFromJavaToJs\"", ").bind(null, wrapCallFromJavaToJs);", "scriptOf;"),
            handedToJs("[\"callFunction\" + i] = ", "(fn, ...values)", "fn(...values)"),
            handedToJs(
                "[\"callMethod\" + i] = ",
                "(instance, method, ...values)",
                "instance !== null ? instance[method](...values) : getGlobalName(method)(...values)",
                end = ").bind(null, rethrowJsAsJava, getGlobalName);",
            ),
            handedToJs("[\"construct\" + i] = ", "(constructor, ...values)", "new constructor(...values)"),
            Triple("new Function(\n      ...argumentList,\n      \"return [\"", ");", "(...values) => values;"),
        )

    /** A function that performs [call] and converts JavaScript errors to Java exceptions. */
    private fun handedToJs(
        place: String,
        parameters: String,
        call: String,
        end: String = ").bind(null, rethrowJsAsJava);",
    ) = Triple(
        "${place}new Function(",
        end,
        "$place$parameters => { try { return $call; } catch (e) { rethrowJsAsJava(e); } };",
    )
}
