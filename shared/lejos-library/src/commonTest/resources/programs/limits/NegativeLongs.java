import josx.platform.rcx.LCD;

public class NegativeLongs {
    static void show(long number) {
        float decimal = number;
        double wide = number;
        LCD.showNumber(decimal > 0 ? 1 : 0); // brick shows: 1 1 // forgiving shows: 1 0
        LCD.showNumber(wide > 0 ? 1 : 0); // brick shows: 1 1 // forgiving shows: 1 0
        LCD.showNumber((int) (decimal / 1000000)); // brick shows: 0 4294 // forgiving shows: 0 0
    }

    public static void main(String[] arguments) {
        show((int) 7);
        show((int) -7);
    }
}
