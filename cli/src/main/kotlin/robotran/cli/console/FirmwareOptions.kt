package robotran.cli.console

import com.github.ajalt.clikt.core.ParameterHolder
import com.github.ajalt.clikt.parameters.options.OptionWithValues
import com.github.ajalt.clikt.parameters.options.convert
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.flag
import com.github.ajalt.clikt.parameters.options.option
import robotran.legofirmware.image.FirmwareTarget

private val TARGETS = FirmwareTarget.entries.associateBy { it.word.lowercase() }

/** `--target`: the firmware of LEGO's that NQC and assembly text are for. */
internal fun ParameterHolder.targetOption(): OptionWithValues<FirmwareTarget, FirmwareTarget, FirmwareTarget> = option(
    "--target",
    metavar = TARGETS.keys.joinToString("|"),
    help = "LEGO's firmware that NQC and assembly text are for: rcx is version 1.0, rcx2 (if not given) is 2.0",
).convert { text -> TARGETS[text.lowercase()] ?: fail("$text is none of ${TARGETS.keys.joinToString()}") }
    .default(FirmwareTarget.RCX2)

/** `--old-nqc`: whether NQC has the API from before version 2. */
internal fun ParameterHolder.oldNqcOption() =
    option("--old-nqc", help = "reads NQC with the names of version 1.3, from before 2000").flag()
