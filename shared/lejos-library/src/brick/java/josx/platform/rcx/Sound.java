package josx.platform.rcx;

/** The brick's loudspeaker; a sound never keeps the program waiting. */
public class Sound {
    private static final int BEEP = 0;
    private static final int TWO_BEEPS = 1;
    private static final int DOWN = 2;
    private static final int BUZZ = 4;

    private Sound() {
    }

    /** Plays one of the brick's own sounds, 0 to 5, after the others or at once. */
    public static void systemSound(boolean isQueued, int code) {
        ROM.call((short) 0x299a, (short) (isQueued ? 0x4004 : 0x4003), (short) code);
    }

    /** Beeps once. */
    public static void beep() {
        systemSound(true, BEEP);
    }

    /** Beeps twice. */
    public static void twoBeeps() {
        systemSound(true, TWO_BEEPS);
    }

    /** Plays a row of tones downwards. */
    public static void beepSequence() {
        systemSound(true, DOWN);
    }

    /** Buzzes. */
    public static void buzz() {
        systemSound(true, BUZZ);
    }

    /** Plays a tone of so many hertz for so many hundredths of a second, at most 255 of them. */
    public static void playTone(int frequency, int duration) {
        ROM.call((short) 0x327c, (short) 0x1773, (short) frequency, (short) duration);
    }
}
