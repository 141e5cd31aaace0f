package lejos.util;

import java.io.PrintStream;
import java.io.Serializable;

/**
 * A matrix of decimal numbers, with rows and columns counted from 0.
 *
 * <p>Methods such as plus make a new matrix; those whose names end in Equals change this one and give it.
 */
public class Matrix implements Cloneable, Serializable {
    private static final long serialVersionUID = 1;

    private static final int PLUS = 0;
    private static final int MINUS = 1;
    private static final int TIMES = 2;
    private static final int DIVIDED = 3;
    private static final int DIVIDES = 4;

    private final double[][] elements;
    private final int rows;
    private final int columns;

    /** Makes one of zeros, with so many rows and columns. */
    public Matrix(int m, int n) {
        this(new double[m][n], m, n);
    }

    /** Makes one with so many rows and columns whose elements are all the same number. */
    public Matrix(int m, int n, double s) {
        this(m, n);
        for (double[] row : elements) {
            for (int j = 0; j < n; j++) row[j] = s;
        }
    }

    /** Makes one that uses an array of rows; all must have the same length. */
    public Matrix(double[][] A) throws IllegalArgumentException {
        this(A, A.length, A[0].length);
        checkRows(A, columns);
    }

    /** Makes one that uses an array of so many rows and columns. */
    public Matrix(double[][] A, int m, int n) {
        elements = A;
        rows = m;
        columns = n;
    }

    /** Makes one with so many rows of numbers that stand column after column. */
    public Matrix(double[] vals, int m) throws IllegalArgumentException {
        this(m, m == 0 ? 0 : vals.length / m);
        if (rows * columns != vals.length) {
            throw new IllegalArgumentException("Array length must be a multiple of m.");
        }
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) elements[i][j] = vals[i + j * rows];
        }
    }

    /** Makes one of a copy of an array of rows; all must have the same length. */
    public static Matrix constructWithCopy(double[][] A) throws IllegalArgumentException {
        checkRows(A, A[0].length);
        return new Matrix(A, A.length, A[0].length).copy();
    }

    private static void checkRows(double[][] array, int length) {
        for (double[] row : array) {
            if (row.length != length) throw new IllegalArgumentException("All rows must have the same length.");
        }
    }

    /** Makes one of random numbers from 0 to 1, with so many rows and columns. */
    public static Matrix random(int m, int n) {
        Matrix made = new Matrix(m, n);
        for (double[] row : made.elements) {
            for (int j = 0; j < n; j++) row[j] = Math.random();
        }
        return made;
    }

    /** Makes one with so many rows and columns that has 1 in its diagonal and 0 elsewhere. */
    public static Matrix identity(int m, int n) {
        Matrix made = new Matrix(m, n);
        for (int i = 0; i < m && i < n; i++) made.elements[i][i] = 1;
        return made;
    }

    /** Makes a copy. */
    public Matrix copy() {
        return new Matrix(getArrayCopy(), rows, columns);
    }

    /** Makes a copy. */
    public Object clone() {
        return copy();
    }

    /** Gives the array of rows that it uses. */
    public double[][] getArray() {
        return elements;
    }

    /** Gives a copy of the array of rows. */
    public double[][] getArrayCopy() {
        double[][] copied = new double[rows][columns];
        for (int i = 0; i < rows; i++) System.arraycopy(elements[i], 0, copied[i], 0, columns);
        return copied;
    }

    /** Gives the numbers column after column. */
    public double[] getColumnPackedCopy() {
        return transpose().getRowPackedCopy();
    }

    /** Gives the numbers row after row. */
    public double[] getRowPackedCopy() {
        double[] copied = new double[rows * columns];
        for (int i = 0; i < rows; i++) System.arraycopy(elements[i], 0, copied, i * columns, columns);
        return copied;
    }

    /** Gives how many rows there are. */
    public int getRowDimension() {
        return rows;
    }

    /** Gives how many columns there are. */
    public int getColumnDimension() {
        return columns;
    }

    /** Gives the element in a row and a column. */
    public double get(int i, int j) {
        return elements[i][j];
    }

    /** Sets the element in a row and a column. */
    public void set(int i, int j, double s) {
        elements[i][j] = s;
    }

    /** Gives the rows from one place to another of the columns from one to another; the last ones belong to it. */
    public Matrix getMatrix(int i0, int i1, int j0, int j1) throws ArrayIndexOutOfBoundsException {
        return getMatrix(places(i0, i1), places(j0, j1));
    }

    /** Gives some rows of some columns. */
    public Matrix getMatrix(int[] r, int[] c) throws ArrayIndexOutOfBoundsException {
        Matrix part = new Matrix(r.length, c.length);
        try {
            for (int i = 0; i < r.length; i++) {
                for (int j = 0; j < c.length; j++) part.elements[i][j] = elements[r[i]][c[j]];
            }
        } catch (ArrayIndexOutOfBoundsException outside) {
            throw new ArrayIndexOutOfBoundsException("Submatrix indices");
        }
        return part;
    }

    /** Gives the rows from one place to another of some columns. */
    public Matrix getMatrix(int i0, int i1, int[] c) throws ArrayIndexOutOfBoundsException {
        return getMatrix(places(i0, i1), c);
    }

    /** Gives some rows of the columns from one place to another. */
    public Matrix getMatrix(int[] r, int j0, int j1) throws ArrayIndexOutOfBoundsException {
        return getMatrix(r, places(j0, j1));
    }

    /** Sets the rows from one place to another of the columns from one to another. */
    public void setMatrix(int i0, int i1, int j0, int j1, Matrix X) throws ArrayIndexOutOfBoundsException {
        setMatrix(places(i0, i1), places(j0, j1), X);
    }

    /** Sets some rows of some columns. */
    public void setMatrix(int[] r, int[] c, Matrix X) throws ArrayIndexOutOfBoundsException {
        try {
            for (int i = 0; i < r.length; i++) {
                for (int j = 0; j < c.length; j++) elements[r[i]][c[j]] = X.elements[i][j];
            }
        } catch (ArrayIndexOutOfBoundsException outside) {
            throw new ArrayIndexOutOfBoundsException("Submatrix indices");
        }
    }

    /** Sets some rows of the columns from one place to another. */
    public void setMatrix(int[] r, int j0, int j1, Matrix X) throws ArrayIndexOutOfBoundsException {
        setMatrix(r, places(j0, j1), X);
    }

    /** Sets the rows from one place to another of some columns. */
    public void setMatrix(int i0, int i1, int[] c, Matrix X) throws ArrayIndexOutOfBoundsException {
        setMatrix(places(i0, i1), c, X);
    }

    private static int[] places(int first, int last) {
        int[] places = new int[last - first + 1];
        for (int i = 0; i < places.length; i++) places[i] = first + i;
        return places;
    }

    /** Gives the matrix whose rows are the columns of this one. */
    public Matrix transpose() {
        Matrix turned = new Matrix(columns, rows);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) turned.elements[j][i] = elements[i][j];
        }
        return turned;
    }

    /** Gives the largest sum of a column, without signs. */
    public double norm1() {
        return transpose().normInf();
    }

    /** Gives the largest sum of a row, without signs. */
    public double normInf() {
        double largest = 0;
        for (int i = 0; i < rows; i++) {
            double sum = 0;
            for (int j = 0; j < columns; j++) sum += Math.abs(elements[i][j]);
            largest = Math.max(largest, sum);
        }
        return largest;
    }

    /** Gives the square root of the sum of all squares. */
    public double normF() {
        double length = 0;
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) length = hypotenuse(length, elements[i][j]);
        }
        return length;
    }

    private static double hypotenuse(double a, double b) {
        double longer = Math.max(Math.abs(a), Math.abs(b));
        if (longer == 0) return 0;
        double part = longer == Math.abs(b) ? a / b : b / a;
        return longer * Math.sqrt(1 + part * part);
    }

    /** Gives the matrix with all signs changed. */
    public Matrix uminus() {
        Matrix changed = new Matrix(rows, columns);
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) changed.elements[i][j] = -elements[i][j];
        }
        return changed;
    }

    /** Gives this matrix plus another. */
    public Matrix plus(Matrix B) {
        return new Matrix(rows, columns).combine(this, B, PLUS);
    }

    /** Adds another matrix to this one. */
    public Matrix plusEquals(Matrix B) {
        return combine(this, B, PLUS);
    }

    /** Gives this matrix minus another. */
    public Matrix minus(Matrix B) {
        return new Matrix(rows, columns).combine(this, B, MINUS);
    }

    /** Subtracts another matrix from this one. */
    public Matrix minusEquals(Matrix B) {
        return combine(this, B, MINUS);
    }

    /** Gives each element times that of another matrix. */
    public Matrix arrayTimes(Matrix B) {
        return new Matrix(rows, columns).combine(this, B, TIMES);
    }

    /** Multiplies each element by that of another matrix. */
    public Matrix arrayTimesEquals(Matrix B) {
        return combine(this, B, TIMES);
    }

    /** Gives each element divided by that of another matrix. */
    public Matrix arrayRightDivide(Matrix B) {
        return new Matrix(rows, columns).combine(this, B, DIVIDED);
    }

    /** Divides each element by that of another matrix. */
    public Matrix arrayRightDivideEquals(Matrix B) {
        return combine(this, B, DIVIDED);
    }

    /** Gives each element of another matrix divided by that of this one. */
    public Matrix arrayLeftDivide(Matrix B) {
        return new Matrix(rows, columns).combine(this, B, DIVIDES);
    }

    /** Sets each element to that of another matrix divided by it. */
    public Matrix arrayLeftDivideEquals(Matrix B) {
        return combine(this, B, DIVIDES);
    }

    private Matrix combine(Matrix a, Matrix b, int operation) {
        if (b.rows != a.rows || b.columns != a.columns) {
            throw new IllegalArgumentException("Matrix dimensions must agree.");
        }
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                elements[i][j] = combined(a.elements[i][j], b.elements[i][j], operation);
            }
        }
        return this;
    }

    private static double combined(double a, double b, int operation) {
        switch (operation) {
            case PLUS:
                return a + b;
            case MINUS:
                return a - b;
            case TIMES:
                return a * b;
            case DIVIDED:
                return a / b;
            default:
                return b / a;
        }
    }

    /** Gives the matrix with all elements multiplied by a number. */
    public Matrix times(double s) {
        return copy().timesEquals(s);
    }

    /** Multiplies all elements by a number. */
    public Matrix timesEquals(double s) {
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) elements[i][j] = s * elements[i][j];
        }
        return this;
    }

    /** Gives the product of this matrix and another, which must have as many rows as this one has columns. */
    public Matrix times(Matrix B) throws IllegalArgumentException {
        if (B.rows != columns) throw new IllegalArgumentException("Matrix inner dimensions must agree.");
        Matrix product = new Matrix(rows, B.columns);
        for (int j = 0; j < B.columns; j++) {
            for (int i = 0; i < rows; i++) {
                double sum = 0;
                for (int k = 0; k < columns; k++) sum += elements[i][k] * B.elements[k][j];
                product.elements[i][j] = sum;
            }
        }
        return product;
    }

    /** Gives the sum of the diagonal. */
    public double trace() {
        double sum = 0;
        for (int i = 0; i < rows && i < columns; i++) sum += elements[i][i];
        return sum;
    }

    /** Gives the inverse of this matrix, which must have as many rows as columns. */
    public Matrix inverse() {
        return solve(identity(rows, rows));
    }

    /** Gives the matrix that is the other one if this one is multiplied by it; this one is a square. */
    public Matrix solve(Matrix B) {
        return new LUDecomposition(this).solve(B);
    }

    /** Writes the rows on the display, whatever the stream is, as leJOS NXJ does. */
    public void print(PrintStream out) {
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) System.out.print(elements[i][j] + " ");
            System.out.println("");
        }
    }
}
