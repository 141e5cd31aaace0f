import josx.platform.rcx.LCD;

public class CharIsLikeShort {
    public static void main(String[] arguments) {
        int number = 65535;
        char letter = (char) number;
        LCD.showNumber(letter == -1 ? 1 : 0); // brick shows: 1 // forgiving shows: 0
    }
}
