public class Algorithms {
    static void quickSort(int[] numbers, int from, int to) {
        if (from >= to) return;
        int pivot = numbers[(from + to) / 2];
        int left = from;
        int right = to;
        while (left <= right) {
            while (numbers[left] < pivot) left++;
            while (numbers[right] > pivot) right--;
            if (left <= right) {
                int swap = numbers[left];
                numbers[left++] = numbers[right];
                numbers[right--] = swap;
            }
        }
        quickSort(numbers, from, right);
        quickSort(numbers, left, to);
    }

    static int hanoi(int disks, int from, int to, int over) {
        return disks == 0 ? 0 : hanoi(disks - 1, from, over, to) + 1 + hanoi(disks - 1, over, to, from);
    }

    static int queens(int row, int columns, int left, int right, int size) {
        if (row == size) return 1;
        int count = 0;
        for (int free = ~(columns | left | right) & ((1 << size) - 1); free != 0; free &= free - 1) {
            int place = free & -free;
            count += queens(row + 1, columns | place, (left | place) << 1, (right | place) >> 1, size);
        }
        return count;
    }

    static long gcd(long a, long b) {
        return b == 0 ? a : gcd(b, a % b);
    }

    static String binary(int number) {
        return number == 0 ? "" : binary(number / 2) + number % 2;
    }

    static double root(double value) {
        double guess = value;
        for (int i = 0; i < 30; i++) guess = (guess + value / guess) / 2;
        return guess;
    }

    static int mandelbrot() {
        int inside = 0;
        for (int row = 0; row < 20; row++) {
            for (int column = 0; column < 30; column++) {
                double x = column * 0.1 - 2;
                double y = row * 0.1 - 1;
                double a = 0;
                double b = 0;
                int steps = 0;
                while (steps < 30 && a * a + b * b < 4) {
                    double next = a * a - b * b + x;
                    b = 2 * a * b + y;
                    a = next;
                    steps++;
                }
                if (steps == 30) inside++;
            }
        }
        return inside;
    }

    public static void main(String[] arguments) {
        int[] numbers = new int[200];
        int seed = 1;
        for (int i = 0; i < numbers.length; i++) {
            seed = seed * 1103515245 + 12345;
            numbers[i] = seed >>> 16;
        }
        quickSort(numbers, 0, numbers.length - 1);
        System.out.println(numbers[0] + " " + numbers[100] + " " + numbers[199]); // expect 1414 33969 65202
        System.out.println(hanoi(10, 1, 3, 2)); // expect 1023
        System.out.println(queens(0, 0, 0, 0, 7)); // expect 40
        System.out.println(gcd(1071L * 1000000007L, 462L * 1000000007L)); // expect 21000000147
        System.out.println(binary(1000)); // expect 1111101000
        System.out.println(Math.abs(root(2) - Math.sqrt(2)) < 1e-15); // expect true
        System.out.println(mandelbrot()); // expect 165
    }
}
