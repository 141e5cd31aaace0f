package robotran.microbit.messages

/** What a call to a chip or a pin has come to. */
internal sealed interface MicrobitMeaning {
    /** Makes something ready. */
    data object SetUp : MicrobitMeaning

    /** @property degrees where the servo of the pen stands now. */
    data class Servo(val degrees: Int) : MicrobitMeaning

    /** Percent of full power that the wheels have now. */
    data class Wheels(val left: Int, val right: Int) : MicrobitMeaning
}
