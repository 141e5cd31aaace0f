package robotran.cli.console

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.NullableOption
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.option
import robotran.tinyvm.config.LejosVersion

private val VERSIONS = LejosVersion.entries.map { it.label }

/** `--lejos`: the version of leJOS; null if not given. */
internal fun ParameterHolder.lejosOption(help: String): NullableOption<LejosVersion, LejosVersion> =
    option("--lejos", metavar = VERSIONS.joinToString("|"), help = help)
        .convert { text -> LejosVersion.of(text) ?: fail("$text is none of ${VERSIONS.joinToString()}") }
