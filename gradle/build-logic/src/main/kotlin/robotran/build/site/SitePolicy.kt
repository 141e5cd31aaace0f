package robotran.build.site

/**
 * The content security policy of the page: its own files and nothing else, no code made of texts, no style but its own.
 * WebAssembly has to be allowed by name. It stands in the page itself, so that it holds wherever the site is hosted.
 *
 * @param script the one script that is in the page.
 * @param style the one style sheet that is in the page.
 */
internal fun policyFor(script: String, style: String): String = listOf(
    "default-src 'none'",
    "script-src 'self' 'wasm-unsafe-eval' '${integrityOf(script.toByteArray())}'",
    "style-src '${integrityOf(style.toByteArray())}'",
    "img-src 'self' data: blob:",
    "connect-src 'self'",
    "manifest-src 'self'",
    "worker-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
).joinToString("; ")
