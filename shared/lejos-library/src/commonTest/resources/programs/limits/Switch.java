import josx.platform.rcx.LCD;

public class Switch {
    static int name(int day) {
        switch (day) { // refused: tableswitch
            case 1:
                return 10;
            case 2:
                return 20;
            default:
                return 0;
        }
    }

    static int find(int number) {
        switch (number) { // refused: lookupswitch
            case 1000:
                return 1;
            case 5:
                return 2;
            default:
                return 0;
        }
    }

    public static void main(String[] arguments) {
        LCD.showNumber(name(1) + find(5));
    }
}
