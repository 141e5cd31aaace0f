import lejos.nxt.Sound;

public class NotesAndSamples {
    public static void main(String[] arguments) {
        Sound.setVolume(100);
        long before = System.currentTimeMillis();
        Sound.playNote(Sound.PIANO, 440, 100);
        int time = (int) (System.currentTimeMillis() - before);
        System.out.println(time >= 95 && time <= 125); // expect true
        byte[] wave = new byte[800];
        for (int i = 0; i < wave.length; i++) wave[i] = (byte) (i % 20 < 10 ? 100 : 156);
        System.out.println(Sound.playSample(wave, 0, wave.length, 8000, 50) >= 0); // expect true
        Sound.pause(150);
        Sound.buzz(); // calls playFreq 100 500 100
        Sound.beepSequence(); // calls playFreq 915 100 100 | playFreq 784 100 100 | playFreq 653 100 100 | playFreq 523 100 100
        System.out.println(Sound.getTime() <= 100); // expect true
    }
}
