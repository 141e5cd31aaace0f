package robotran.hub.program

/** What a colour or light sensor measures, as a program asks for it; Pybricks has a method for each. */
enum class LightMode {
    /** The light of its own lamp that comes back. */
    REFLECTION,

    /** The light around, without its lamp. */
    AMBIENT,
}
