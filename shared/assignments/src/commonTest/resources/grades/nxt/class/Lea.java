import lejos.nxt.*;

public class Lea {
    public static void main(String[] args) {
        String text = "a";
        while (true) {
            text = text + text;
            System.out.println(text.length());
        }
    }
}
