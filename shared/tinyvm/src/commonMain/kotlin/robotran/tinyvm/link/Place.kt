package robotran.tinyvm.link

import robotran.tinyvm.diagnostic.Refusal
import robotran.tinyvm.diagnostic.RefusalException
import robotran.tinyvm.messages.LinkMessages

/** Where in a program something is wrong: a class with slashes in its name, a method and a line as far as they are known. */
internal class Place(private val className: String, private val methodName: String? = null, private val line: Int = 0) {
    fun refuse(message: String): Nothing = throw RefusalException(Refusal(message, className.replace('/', '.'), methodName, line))

    fun unsound(messages: LinkMessages): Nothing = refuse(messages.codeUnsound())
}
