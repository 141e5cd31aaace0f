package robotran.lejoslinker.messages

import robotran.tinyvm.messages.TinyVmMessages

/** What the virtual machine of the simulated brick says, too. */
val ImageMessages.tinyVm: TinyVmMessages get() = TinyVmMessages.of(language)

/** Says that the class with the internal [name] is missing. */
internal fun ImageMessages.classMissing(name: String): String = tinyVm.classMissing(name.replace('/', '.'))

/** The assignment that adds [step] to [variable]. */
internal fun longForm(variable: String, step: Int): String =
    if (step < 0) "$variable = $variable - ${-step}" else "$variable = $variable + $step"
