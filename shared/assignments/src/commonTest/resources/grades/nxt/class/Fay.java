import lejos.nxt.*;

public class Fay {
    public static void main(String[] args) {
        int[] none = null;
        LCD.drawInt(none[3], 0, 0);
    }
}
