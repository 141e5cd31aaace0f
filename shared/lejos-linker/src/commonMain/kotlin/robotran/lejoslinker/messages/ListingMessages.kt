package robotran.lejoslinker.messages

import robotran.lejoslinker.image.PartKind

/** The words of a listing; headings end with a colon. */
interface ListingMessages {
    /** The heading of the parts of an image of [bytes]. */
    fun parts(bytes: Int): String

    fun partName(kind: PartKind): String

    /** [bytes] from byte [offset] on. */
    fun bytesAt(bytes: Int, offset: Int): String

    /** The size of an object. */
    fun objectBytes(bytes: Int): String

    fun entryClasses(): String

    fun classes(): String

    fun constants(): String

    fun staticFields(): String

    fun signatures(): String
}
