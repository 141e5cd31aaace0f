package robotran.hub.program

/** What a sensor at a port measures now; immutable. */
sealed interface HubReading {
    /**
     * A colour sensor, as its hub gets it.
     *
     * @property red 0..1024; so are [green] and [blue].
     * @property ambient the light around, 0..100 percent.
     */
    data class Light(val red: Int, val green: Int, val blue: Int, val ambient: Int = 0) : HubReading {
        /** 0..100 percent. */
        val reflection: Int get() = (red + green + blue) * PERCENT / BRIGHTEST_SUM

        /** What the sensor tells in [mode], 0..100 percent. */
        fun brightness(mode: LightMode): Int = if (mode == LightMode.AMBIENT) ambient else reflection
    }

    /** An ultrasonic sensor; [FAR] and its like stand for nothing ahead. */
    data class Distance(val millimetres: Int) : HubReading

    /**
     * A force or touch sensor.
     *
     * @property decinewtons a tenth of a newton each, 0..100; those of a touch sensor count from 3 newtons as pressed.
     */
    data class Force(val decinewtons: Int) : HubReading {
        val isTouched: Boolean get() = decinewtons > 0
        val isPressed: Boolean get() = decinewtons >= PRESSED
    }

    /** A sound sensor, 0..100 percent. */
    data class Sound(val intensity: Int) : HubReading

    companion object {
        /** What an ultrasonic sensor of SPIKE says with nothing ahead, millimetres. */
        const val FAR = 2000

        /** The same of an EV3's and an NXT's. */
        const val FAR_OLDER = 2550

        /** The brightest that a colour sensor of SPIKE sees in a colour. */
        const val BRIGHTEST = 1024

        private const val PERCENT = 100
        private const val BRIGHTEST_SUM = 3 * BRIGHTEST
        private const val PRESSED = 30
    }
}
