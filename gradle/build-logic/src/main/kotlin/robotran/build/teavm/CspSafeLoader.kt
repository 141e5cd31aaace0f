package robotran.build.teavm

import org.gradle.api.GradleException

/**
 * Rewrites TeaVM's loader so that it makes no code of texts: a page's security policy may then forbid it. TeaVM does so
 * to give functions exactly as many parameters as they have in Java, which nothing here looks at, and for scripts that
 * are written in Java (`@JSBody`), which are few and known.
 */
internal object CspSafeLoader {
    /**
     * @param loader the readable `wasm-gc-module-runtime.js` of the TeaVM that is in the version catalogue.
     * @param functions `without-eval.mjs`, which has what is put in place of the texts.
     */
    fun rewrite(loader: String, functions: String): String {
        var text = loader
        for ((start, end, replacement) in REPLACEMENTS) text = replaceOnce(text, start, end, replacement)
        if ("Function(" in text.replace("defineFunction(", "").replace("asFunction(", "")) {
            throw GradleException("TeaVM's loader makes code of texts in more places than CspSafeLoader knows.")
        }
        return functions + "\n" + text
    }

    /** Puts [replacement] in place of what begins with [start] and ends with the next [end]. */
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

    /** A function that does [call], and throws in Java what goes wrong in JavaScript. */
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
