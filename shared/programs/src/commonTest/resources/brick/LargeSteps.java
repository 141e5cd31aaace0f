import josx.platform.rcx.LCD;

/** leJOS's linker takes only small steps of a variable of a method. */
public class LargeSteps {
    static int total = 0;

    public static void main(String[] args) throws InterruptedException {
        int way = 1;
        way += 1000; // brick error: way = way + 1000
        way -= 300; // brick error: way = way - 300
        way = way + 200;
        way += 127;
        way -= 128;
        total += 1000;
        LCD.showNumber(way + total);
        Thread.sleep(2000);
    }
}
// forgiving display: 1900
