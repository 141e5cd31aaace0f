// Plays a melody. One array holds five notes in hertz, and the two
// tunes say which of them comes when.
// Next: write down a tune you know.

import josx.platform.rcx.LCD;
import josx.platform.rcx.Sound;

public class Melody {
    static final int[] NOTES = {262, 294, 330, 349, 392};
    static final int[] QUESTION = {2, 2, 3, 4, 4, 3, 2, 1};
    static final int[] ANSWER = {0, 0, 1, 2, 1, 0, 0};
    static final int BEAT_HUNDREDTHS = 40; // of a second

    public static void main(String[] args) throws InterruptedException {
        sing(QUESTION);
        sing(ANSWER);
    }

    static void sing(int[] tune) throws InterruptedException {
        for (int place = 0; place < tune.length; place++) {
            LCD.showNumber(tune[place]);
            // No sound waits for its end, so the program has to.
            Sound.playTone(NOTES[tune[place]], BEAT_HUNDREDTHS);
            Thread.sleep(BEAT_HUNDREDTHS * 10);
        }
    }
}
