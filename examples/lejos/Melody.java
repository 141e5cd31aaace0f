import josx.platform.rcx.Sound;

/** Plays the beginning of Ode to Joy. */
public class Melody {
    static final int C = 523;
    static final int D = 587;
    static final int E = 659;
    static final int F = 698;
    static final int G = 784;

    static final int[] TONES = {E, E, F, G, G, F, E, D, C, C, D, E, E, D, D};
    static final int[] LENGTHS = {2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 1, 4};

    public static void main(String[] arguments) throws InterruptedException {
        for (int note = 0; note < TONES.length; note++) {
            int hundredths = LENGTHS[note] * 20;
            Sound.playTone(TONES[note], hundredths - 2);
            Thread.sleep(hundredths * 10);
        }
    }
}
