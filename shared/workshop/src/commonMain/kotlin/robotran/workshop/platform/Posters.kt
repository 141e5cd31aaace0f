package robotran.workshop.platform

import robotran.workshop.state.Poster

/** Writes and prints posters, each on one page of A4. */
interface Posters {
    /** Whether this machine can print. */
    val canPrint: Boolean

    /** The page as SVG text, the same on every platform. */
    fun svg(poster: Poster): String

    /** The page as a PNG picture that fills a screen; null if the platform cannot draw it now. */
    suspend fun png(poster: Poster): ByteArray?

    /** Shows the platform's print dialog and prints. */
    suspend fun print(poster: Poster): Printing
}

/** The result of printing. */
sealed interface Printing {
    /** The print dialog has the page; whether it was printed is up to the user, and not always reported. */
    data object HandedOver : Printing

    data object Cancelled : Printing

    /** @property reason the platform's error message. */
    data class Failed(val reason: String) : Printing
}

/** A platform without printers. */
object NoPosters : Posters {
    override val canPrint: Boolean get() = false

    override fun svg(poster: Poster): String = ""

    override suspend fun png(poster: Poster): ByteArray? = null

    override suspend fun print(poster: Poster): Printing = Printing.Cancelled
}
