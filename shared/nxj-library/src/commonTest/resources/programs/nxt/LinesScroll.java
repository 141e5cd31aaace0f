// screen line 7
// screen line 8
// screen line 9
// screen a long line that
// screen  wraps
// screen x=7.0 1234567890
// screen 123
public class LinesScroll {
    public static void main(String[] arguments) throws InterruptedException {
        for (int line = 0; line < 10; line++) System.out.println("line " + line);
        System.out.println("a long line that wraps");
        System.out.println("x=" + 3.5f * 2 + " " + 1234567890123L);
        Thread.sleep(300);
    }
}
