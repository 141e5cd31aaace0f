package robotran.tinyvm.link

import robotran.tinyvm.diagnostic.LinkError
import robotran.tinyvm.diagnostic.LinkException
import robotran.tinyvm.messages.LinkMessages

/** The location of an error: the internal class name, and the method and line if they are known. */
internal class CodeLocation(
    private val className: String,
    private val methodName: String? = null,
    private val line: Int = 0,
) {
    fun reject(message: String): Nothing =
        throw LinkException(LinkError(message, className.replace('/', '.'), methodName, line))

    fun unsound(messages: LinkMessages): Nothing = reject(messages.codeInvalid())
}
