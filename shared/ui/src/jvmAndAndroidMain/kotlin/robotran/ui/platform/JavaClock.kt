package robotran.ui.platform

import robotran.workshop.platform.WallClock
import java.time.Instant
import java.time.LocalDate
import java.time.ZoneId
import java.time.format.DateTimeFormatter
import java.time.format.FormatStyle
import java.util.Locale

/** The system clock. */
object JavaClock : WallClock {
    override val now: Long get() = System.currentTimeMillis()

    override fun describe(milliseconds: Long, language: String): String {
        val time = Instant.ofEpochMilli(milliseconds).atZone(ZoneId.systemDefault())
        val isToday = time.toLocalDate() == LocalDate.now()
        val ofToday = DateTimeFormatter.ofLocalizedTime(FormatStyle.SHORT)
        val format = if (isToday) ofToday else DateTimeFormatter.ofLocalizedDate(FormatStyle.MEDIUM)
        return time.format(format.withLocale(localeOf(language)))
    }

    override fun date(milliseconds: Long, language: String): String =
        Instant.ofEpochMilli(milliseconds).atZone(ZoneId.systemDefault())
            .format(DateTimeFormatter.ofLocalizedDate(FormatStyle.LONG).withLocale(localeOf(language)))

    /** The system's variant of [language], if it has the same language: British and American dates differ. */
    private fun localeOf(language: String): Locale {
        val own = Locale.getDefault()
        return if (language.isEmpty() || own.language == language) own else Locale.forLanguageTag(language)
    }
}
