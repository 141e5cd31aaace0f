package robotran.simulation.light

import robotran.world.Shade

/** The parts of red, green and blue light that a surface reflects, each 0..1. */
internal class Tint(val red: Double, val green: Double, val blue: Double) {
    companion object {
        private const val FULL = 255.0

        fun grey(reflectance: Double) = Tint(reflectance, reflectance, reflectance)

        fun of(shade: Shade): Tint = when (shade) {
            is Shade.Grey -> grey(shade.reflectance)
            is Shade.Colour -> Tint(shade.red / FULL, shade.green / FULL, shade.blue / FULL)
        }
    }
}
