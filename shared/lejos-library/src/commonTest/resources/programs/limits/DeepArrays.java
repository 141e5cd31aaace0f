import josx.platform.rcx.LCD;

public class DeepArrays {
    static int lengthOf(int way) {
        try {
            if (way == 0) return new int[2][3][4].length;
            if (way == 1) return new int[2][3][].length;
            if (way == 2) return new int[1][3][4].length;
            return new int[2][][].length;
        } catch (OutOfMemoryError tooDeep) {
            return 0;
        }
    }

    public static void main(String[] arguments) {
        for (int way = 0; way < 4; way++) {
            LCD.showNumber(lengthOf(way)); // brick shows: 0 0 1 2 // forgiving shows: 2 2 1 2
        }
    }
}
