package robotran.build.site

/**
 * The content security policy of the page. It allows only the site's own files and forbids `eval` and foreign styles.
 * WebAssembly is allowed explicitly. The policy is part of the page itself, so it applies on any host.
 *
 * @param script the only inline script of the page.
 * @param style the only inline style sheet of the page.
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
