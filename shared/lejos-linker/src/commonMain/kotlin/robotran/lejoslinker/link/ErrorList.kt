package robotran.lejoslinker.link

import robotran.tinyvm.diagnostic.LinkError

/** Where a mistake is; [className] has slashes, [line] is 0 if it is unknown. */
internal data class CodePlace(val className: String, val methodName: String? = null, val line: Int = 0)

/** Collects mistakes, each once. */
internal class ErrorList {
    private val found = LinkedHashSet<LinkError>()

    val isEmpty: Boolean get() = found.isEmpty()

    fun add(place: CodePlace, message: String) {
        if (found.size == MAX_ERRORS) return
        found += LinkError(message, place.className.replace('/', '.'), place.methodName, place.line)
    }

    /** All of them, with the source file that [sourceFileOf] returns for an internal class name. */
    fun withFiles(sourceFileOf: (String) -> String?): List<LinkError> = found.map {
        it.copy(sourceFile = sourceFileOf(it.className.replace('.', '/')))
    }

    private companion object {
        /** More than a learner reads. */
        const val MAX_ERRORS = 100
    }
}
