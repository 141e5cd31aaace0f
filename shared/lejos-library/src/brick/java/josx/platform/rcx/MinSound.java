package josx.platform.rcx;

/**
 * The brick's loudspeaker with tones only.
 *
 * @deprecated use Sound.
 */
public class MinSound {
    private MinSound() {
    }

    /** Plays a tone of so many hertz for so many hundredths of a second, at most 255 of them. */
    public static void playTone(int frequency, int duration) {
        ROM.call((short) 0x327c, (short) 0x1773, (short) frequency, (short) duration);
    }
}
